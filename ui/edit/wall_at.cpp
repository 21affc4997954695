// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/wall_at.h"

#include "geometry/polygon.h"
#include "geometry/segment.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "solver/scene/shapes.h"
#include "ui/edit/names.h"

#include <algorithm>

namespace keyblock {
namespace {

std::optional<TunnelProfile> profileOf(const SceneTunnel& tunnel) {
    if (!isUsable(tunnel.center) || !std::all_of(tunnel.points.begin(), tunnel.points.end(), isUsable)) return std::nullopt;
    if (profileProblem(shapeOf(tunnel))) return std::nullopt;
    return tunnelProfile(shapeOf(tunnel));
}

/// Finds the edge nearest to `place` on an outline with the rock inside. True if it is nearer than the best so far.
bool lookAt(const std::vector<Point>& points, const Point& place, double& radius, std::optional<WallPlace>& best) {
    bool nearer = false;
    if (points.size() < 3 || !std::all_of(points.begin(), points.end(), isUsable)) return nearer;
    const std::vector<Point> corners = counterClockwise(points);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double distance = distanceToSegment(a, b, place);
        if (a == b || distance >= radius) continue;
        radius = distance;
        const double on = std::clamp(footParameter(a, b, place), 0.0, 1.0);
        best = WallPlace{a + on * (b - a), turnLeft(b - a).normalized(), 0.0, -1, {}};
        nearer = true;
    }
    return nearer;
}

}  // namespace

std::optional<WallPlace> wallOfTunnel(const Scene& scene, int tunnel, const Point& place) {
    if (tunnel < 0 || tunnel >= static_cast<int>(scene.tunnels.size()) || !isUsable(place)) return std::nullopt;
    const SceneTunnel& drawn = scene.tunnels[tunnel];
    const auto profile = profileOf(drawn);
    if (!profile) return std::nullopt;
    const double along = lengthOfNearest(*profile, place);
    return WallPlace{outlinePointAtLength(*profile, along), normalAtLength(*profile, along), along, tunnel,
                     "wall of " + titleAt(scene, under("/tunnels", static_cast<std::size_t>(tunnel)))};
}

std::optional<WallPlace> wallAt(const Scene& scene, const Point& place, double radius) {
    std::optional<WallPlace> best;
    double nearest = radius;
    for (int i = 0; i < static_cast<int>(scene.tunnels.size()); ++i) {
        const auto wall = wallOfTunnel(scene, i, place);
        const double distance = wall ? (wall->place - place).norm() : radius;
        if (!wall || distance >= nearest) continue;
        nearest = distance;
        best = wall;
    }
    if (best) return best;
    if (scene.domain && lookAt(scene.domain->boundary, place, nearest, best)) best->name = "face of the domain";
    for (std::size_t i = 0; i < scene.blocks.size(); ++i)
        if (lookAt(scene.blocks[i].points, place, nearest, best))
            best->name = "face of " + titleAt(scene, under("/blocks", i));
    return best;
}

double runAlong(const SceneTunnel& tunnel, double from, double to, Way way) {
    const auto profile = profileOf(tunnel);
    if (!profile) return 0.0;
    const double run = lengthBetween(*profile, from, to, way);
    return run > 0.0 ? run : profile->length;
}

std::vector<Point> wallBetween(const SceneTunnel& tunnel, double from, double to, Way way) {
    const auto profile = profileOf(tunnel);
    if (!profile) return {};
    const double run = runAlong(tunnel, from, to, way), sign = way == Way::CounterClockwise ? 1.0 : -1.0;
    // Adds the polygon's corners in between, so that the line follows the wall as it is drawn.
    std::vector<double> stops{0.0, run};
    for (const ProfilePiece& piece : profile->pieces)
        for (int i = 0; i < piece.edges; ++i) {
            const double at = piece.begin + piece.length * i / piece.edges;
            const double off = lengthBetween(*profile, from, at, way);
            if (off > 0.0 && off < run) stops.push_back(off);
        }
    std::sort(stops.begin(), stops.end());
    std::vector<Point> line;
    for (const double stop : stops) line.push_back(outlinePointAtLength(*profile, from + sign * stop));
    return line;
}

}  // namespace keyblock
