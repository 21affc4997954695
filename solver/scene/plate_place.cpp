// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tries every edge at the head: the plate is placed on the outer side of the
// edge and accepted if it overlaps no rock. All accepted positions must have
// the same direction.
#include "solver/scene/plate_place.h"

#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double parallel = 1e-6;  // sine of the angle below which faces count as parallel
constexpr double nearShare = 1e-6;  // ratio to the plate width; a head that is closer to a face than this lies on it

struct Face {
    int block = -1;
    Point from{0.0, 0.0}, along{1.0, 0.0};  // start and direction, counter-clockwise around the block
    double length = 0.0;  // [m]

    Point outward() const { return -turnLeft(along); }
};

template <class Visit>
void forEachFace(const Scene& scene, Visit visit) {
    for (std::size_t b = 0; b < scene.blocks.size(); ++b) {
        const std::vector<Point> corners = counterClockwise(scene.blocks[b].points);
        for (std::size_t e = 0; e < corners.size(); ++e) {
            const Point chord = corners[(e + 1) % corners.size()] - corners[e];
            visit(Face{static_cast<int>(b), corners[e], chord / chord.norm(), chord.norm()});
        }
    }
}

double distanceTo(const Face& face, const Point& p) {
    return distanceToSegment(face.from, face.from + face.length * face.along, p);
}

std::vector<Point> outlineOn(const Face& face, const Point& foot, const Plate& plate) {
    const Point half = 0.5 * plate.width * face.along, deep = plate.thickness * face.outward();
    return {foot + half, foot - half, foot - half + deep, foot + half + deep};
}

bool overlapsRock(const Scene& scene, const std::vector<Point>& outline, double tolerance) {
    const Box box = grown(boxOf(outline), tolerance);
    return std::any_of(scene.blocks.begin(), scene.blocks.end(), [&](const Block& block) {
        return meets(boxOf(block.points), box) && overlap(block.points, outline, tolerance);
    });
}

bool sameWay(const Point& a, const Point& b) { return a.dot(b) > 0.0 && std::abs(cross(a, b)) < parallel; }

/// Part of the plate's width that is backed by faces in its plane [m].
double backedWidth(const Scene& scene, const PlatePlace& place, double width, double near) {
    const Point along = turnLeft(place.outward);  // direction of faces that have this outward normal
    double backed = 0.0;
    forEachFace(scene, [&](const Face& face) {
        const double off = place.outward.dot(face.from - place.foot);
        if (!sameWay(face.outward(), place.outward) || std::abs(off) > near) return;
        const double s = along.dot(face.from - place.foot);
        backed += std::max(0.0, std::min(0.5 * width, s + face.length) - std::max(-0.5 * width, s));
    });
    return backed;
}

}  // namespace

PlatePlace placePlate(const Scene& scene, const Bolt& bolt) {
    const Plate& plate = boltTypeOf(scene, bolt).plate;
    const double near = std::max(10.0 * geometricTolerance(scene), nearShare * plate.width);
    PlatePlace place;
    place.away = std::numeric_limits<double>::infinity();
    bool candidates = false, found = false, several = false;
    forEachFace(scene, [&](const Face& face) {
        const double away = distanceTo(face, bolt.head);
        place.away = std::min(place.away, away);
        if (away > near) return;
        candidates = true;
        const Point foot = bolt.head - face.outward().dot(bolt.head - face.from) * face.outward();
        std::vector<Point> outline = outlineOn(face, foot, plate);
        if (overlapsRock(scene, outline, near)) return;
        if (found) {
            several = several || !sameWay(face.outward(), place.outward);
            return;
        }
        found = true;
        place.block = face.block;
        place.foot = foot;
        place.outward = face.outward();
        place.outline = std::move(outline);
    });
    if (!found) {
        place.fault = candidates ? PlateFault::InRock : PlateFault::NoFace;
        return place;
    }
    if (several) place.fault = PlateFault::Corner;
    else if (place.outward.dot(bolt.head - bolt.farEnd) <= 0.0) place.fault = PlateFault::Behind;
    place.overhang = std::max(0.0, plate.width - backedWidth(scene, place, plate.width, near));
    return place;
}

}  // namespace keyblock
