// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/hit.h"

#include "geometry/segment.h"

#include <algorithm>
#include <array>
#include <limits>

namespace keyblock {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double kindStep = 0.3;  // penalty from one kind to the next, relative to the radius
constexpr double inside = 10.0;  // penalty of interiors, which come after all lines

/// Penalty of a kind: small objects and those drawn above others come first.
double rankOf(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::Monitor:
        case ObjectKind::Load:
        case ObjectKind::Motion:
        case ObjectKind::Velocity: return 0.0;
        case ObjectKind::Bolt:
        case ObjectKind::Pattern: return kindStep;
        case ObjectKind::Joint: return 2.0 * kindStep;
        case ObjectKind::Tunnel:
        case ObjectKind::Block: return 2.5 * kindStep;
        case ObjectKind::Support: return 3.0 * kindStep;
        case ObjectKind::Region:
        case ObjectKind::Domain: return 3.5 * kindStep;
        default: return 4.0 * kindStep;  // joint sets and Voronoi cells cover large areas
    }
}

template <typename Visit>
void eachSegment(const ObjectLine& line, Visit visit) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) visit(line.points[i], line.points[i + 1]);
    if (line.closed && line.points.size() > 2) visit(line.points.back(), line.points.front());
}

double distanceTo(const SceneObject& object, const Point& place) {
    double nearest = none;
    for (const Point& mark : object.marks) nearest = std::min(nearest, (mark - place).norm());
    for (const ObjectLine& line : object.lines)
        eachSegment(line, [&](const Point& a, const Point& b) { nearest = std::min(nearest, distanceToSegment(a, b, place)); });
    return nearest;
}

bool holds(const Box& box, const Point& p) {
    return (p.array() >= box.min.array()).all() && (p.array() <= box.max.array()).all();
}

bool touches(const Box& box, const Point& a, const Point& b) {
    if (holds(box, a) || holds(box, b)) return true;
    const std::array<Point, 4> corners{box.min, Point(box.max.x(), box.min.y()), box.max, Point(box.min.x(), box.max.y())};
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (crossing(a, b, corners[i], corners[(i + 1) % corners.size()])) return true;
    return false;
}

bool isChosen(const SceneObject& object, const Box& box, BoxRule rule) {
    bool all = true, some = false;
    for (const Point& mark : object.marks) holds(box, mark) ? some = true : all = false;
    for (const ObjectLine& line : object.lines) {
        for (const Point& point : line.points) all = all && holds(box, point);
        eachSegment(line, [&](const Point& a, const Point& b) { some = some || touches(box, a, b); });
    }
    return rule == BoxRule::Encloses ? all : some;
}

}  // namespace

std::vector<std::size_t> objectsAt(std::span<const SceneObject> objects, const Point& place, double radius) {
    std::vector<std::pair<double, std::size_t>> met;
    const bool opening = isInOpening(objects, place);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (opening && endsAtOpenings(objects[i].kind)) continue;
        const double distance = distanceTo(objects[i], place);
        if (distance <= radius)
            met.emplace_back(distance / radius + rankOf(objects[i].kind), i);
        else if (!objects[i].area.empty() && locate(objects[i].area, place, 0.0) == Side::Inside)
            met.emplace_back(inside + std::abs(signedArea(objects[i].area)), i);
    }
    std::sort(met.begin(), met.end());
    std::vector<std::size_t> found;
    for (const auto& [score, index] : met) found.push_back(index);
    return found;
}

std::vector<std::size_t> objectsIn(std::span<const SceneObject> objects, const Box& box, BoxRule rule) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (isChosen(objects[i], box, rule)) found.push_back(i);
    return found;
}

}  // namespace keyblock
