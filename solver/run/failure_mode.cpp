// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The movement of blocks is treated as rigid, because their deformation is small
// compared with the movement in a failure. The movement of a joint is determined from
// the motion of its two blocks at its contacts, because a contact that has opened no
// longer exists.
#include "solver/run/failure_mode.h"

#include "geometry/segment.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace keyblock {

namespace {

constexpr double reportedShare = 0.1;  // fraction of the largest movement: smaller movements are not reported
constexpr double plumb = 0.984807753012208;  // cos 10°
// fraction of the smaller block's size: a corner this close to an edge touches it
constexpr double touchingCorner = 0.01;
constexpr double onEdge = 1e-6;  // fraction of the block's size: tolerance within which a point lies on two edges

double sizeOf(const BlockState& block) {
    double size = 0.0;
    for (const Point& corner : block.points) size = std::max(size, (corner - block.centroid).norm());
    return size;
}

bool isThere(const BlockState& block) { return block.area > 0.0; }

/// Displacement of the point of a block that was at `place`.
Point way(const BlockState& before, const BlockState& after, const Point& place) {
    const Eigen::Rotation2Dd turn(after.rotation - before.rotation);
    return after.centroid + turn * Point(place - before.centroid) - place;
}

/// Earlier position of the point of a block that is now at `place`.
Point placeBefore(const BlockState& before, const BlockState& after, const Point& place) {
    const Eigen::Rotation2Dd turn(before.rotation - after.rotation);
    return before.centroid + turn * Point(place - after.centroid);
}

/// Outward normal, at `place`, of the edge of `edges` that faces `other` most directly.
/// \pre the corners are in counter-clockwise order.
Point normalAt(const BlockState& edges, const Point& place, const Point& other) {
    const std::vector<Point>& corners = edges.points;
    double nearest = std::numeric_limits<double>::infinity();
    const auto away = [&](std::size_t i) {
        return distanceToSegment(corners[i], corners[(i + 1) % corners.size()], place);
    };
    for (std::size_t i = 0; i < corners.size(); ++i) nearest = std::min(nearest, away(i));
    Point best(0.0, 0.0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (away(i) > nearest + onEdge * sizeOf(edges)) continue;
        const Point along = (corners[(i + 1) % corners.size()] - corners[i]).normalized();
        const Point normal(along.y(), -along.x());
        if (best.isZero() || normal.dot(other - place) > best.dot(other - place)) best = normal;
    }
    return best;
}

double movement(const MovingJoint& joint) { return std::hypot(joint.slip, joint.opening); }

/// Sorts by movement, largest first, and omits what moves less than a tenth of the largest movement.
template <typename Row, typename Measure>
void keepLargest(std::vector<Row>& rows, const Measure& measure) {
    std::ranges::stable_sort(rows, [&](const Row& a, const Row& b) { return measure(a) > measure(b); });
    const double least = rows.empty() ? 0.0 : reportedShare * measure(rows.front());
    std::erase_if(rows, [&](const Row& row) { return measure(row) < least || measure(row) == 0.0; });
}

/// A corner of block a touches an edge of block b at `place`.
struct Touch {
    std::size_t a = 0, b = 0;
    Point place{0.0, 0.0};
};

void add(MovingJoint& joint, const Touch& touch, const Frame& before, const Frame& after) {
    const auto& [a, b, place] = touch;
    const Point normal = normalAt(before.blocks[b], place, before.blocks[a].centroid);
    const Point apart = way(before.blocks[a], after.blocks[a], place) - way(before.blocks[b], after.blocks[b], place);
    const double slip = std::abs(cross(normal, apart)), opening = std::max(normal.dot(apart), 0.0);
    if (joint.blockA < 0 || std::hypot(slip, opening) > movement(joint)) joint.position = place;
    joint.blockA = static_cast<int>(std::min(a, b));
    joint.blockB = static_cast<int>(std::max(a, b));
    joint.slip = std::max(joint.slip, slip);
    joint.opening = std::max(joint.opening, opening);
}

/// Uses the contacts of both frames: at the start of a stage blocks may not be pressed together yet, and after a
/// failure they may no longer be.
std::vector<MovingJoint> jointsBetween(const Frame& before, const Frame& after) {
    std::map<std::pair<int, int>, MovingJoint> joints;
    const auto look = [&](const Frame& frame) {
        for (const ContactFrame& contact : frame.contacts) {
            const auto a = static_cast<std::size_t>(contact.blockA), b = static_cast<std::size_t>(contact.blockB);
            if (!isThere(before.blocks[a]) || !isThere(after.blocks[a]) || !isThere(before.blocks[b]) ||
                !isThere(after.blocks[b]))
                continue;
            const Point place = &frame == &before
                                    ? contact.position
                                    : placeBefore(before.blocks[b], after.blocks[b], contact.position);
            MovingJoint& joint = joints[std::minmax(contact.blockA, contact.blockB)];
            add(joint, {a, b, place}, before, after);
            joint.jointMaterial = contact.jointMaterial;
        }
    };
    look(before);
    look(after);
    std::vector<MovingJoint> list;
    for (const auto& [pair, joint] : joints) list.push_back(joint);
    return list;
}

bool isApart(const BlockState& a, const BlockState& b, double distance) {
    return (a.centroid - b.centroid).norm() > sizeOf(a) + sizeOf(b) + distance;
}

/// Adds the corners of block a that lie on edges of block b.
void addTouches(const Frame& frame, std::size_t a, std::size_t b, double distance, std::vector<Touch>& touches) {
    const std::vector<Point>& edges = frame.blocks[b].points;
    for (const Point& corner : frame.blocks[a].points)
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (distanceToSegment(edges[i], edges[(i + 1) % edges.size()], corner) <= distance) {
                touches.push_back({a, b, corner});
                break;
            }
}

/// Points at which two blocks touch along a length; empty if only corners meet.
std::vector<Touch> touchesOf(const Frame& frame, std::size_t a, std::size_t b) {
    const double smaller = std::min(sizeOf(frame.blocks[a]), sizeOf(frame.blocks[b])), distance = touchingCorner * smaller;
    std::vector<Touch> touches;
    if (isApart(frame.blocks[a], frame.blocks[b], distance)) return touches;
    addTouches(frame, a, b, distance, touches);
    addTouches(frame, b, a, distance, touches);
    const bool along = std::ranges::any_of(touches, [&](const Touch& touch) {
        return (touch.place - touches.front().place).norm() > 4.0 * distance;
    });
    return along ? touches : std::vector<Touch>{};
}

}  // namespace

std::vector<MovingJoint> jointsAround(const Frame& before, const Frame& after, const std::vector<int>& rows) {
    std::vector<MovingJoint> joints;
    for (const int row : rows) {
        const std::size_t a = row;
        for (std::size_t b = 0; b < before.blocks.size(); ++b) {
            if (std::ranges::find(rows, static_cast<int>(b)) != rows.end()) continue;
            if (!isThere(before.blocks[a]) || !isThere(after.blocks[a]) || !isThere(before.blocks[b]) ||
                !isThere(after.blocks[b]))
                continue;
            MovingJoint joint;
            for (const Touch& touch : touchesOf(before, a, b)) add(joint, touch, before, after);
            if (joint.blockA < 0) continue;
            joint.blockA = row;
            joint.blockB = static_cast<int>(b);
            joints.push_back(joint);
        }
    }
    return joints;
}

Movement movementOf(const Point& displacement, double rotation, double size, const Point& down) {
    if (displacement.norm() < 2.0 * size * std::abs(rotation)) return Movement::Topples;
    const bool falls = displacement.dot(down) > plumb * displacement.norm() * down.norm() && down.norm() > 0.0;
    return falls ? Movement::Falls : Movement::Slides;
}

FailureMode failureMode(const Frame& before, const Frame& after, const Point& down) {
    FailureMode mode;
    for (std::size_t i = 0; i < after.blocks.size(); ++i) {
        const BlockState &from = before.blocks[i], &to = after.blocks[i];
        if (!isThere(from) || !isThere(to)) continue;
        const Point displacement = to.centroid - from.centroid;
        const double rotation = to.rotation - from.rotation;
        mode.blocks.push_back(
            {static_cast<int>(i), movementOf(displacement, rotation, sizeOf(to), down), displacement, rotation});
    }
    keepLargest(mode.blocks, [&](const MovingBlock& block) {
        const BlockState& there = after.blocks[block.block];
        return block.displacement.norm() + std::abs(block.rotation) * sizeOf(there);
    });
    mode.joints = jointsBetween(before, after);
    keepLargest(mode.joints, movement);
    return mode;
}

}  // namespace keyblock
