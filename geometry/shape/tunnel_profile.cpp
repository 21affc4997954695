// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds the pieces of a profile from the numbers of its shape. Directions on arcs are in degrees, in which quarter
// turns are exact, so crowns and springing lines are exactly where the user expects them.
#include "geometry/shape/tunnel_profile.h"

#include "geometry/angle.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

Point onArc(const Arc& arc, double degrees) { return arc.center + arc.radius * directionOf(degrees); }

int edgesOf(const Arc& arc, std::optional<double> sagitta) {
    double onCircle = leastEdgesOfCircle;
    if (sagitta && *sagitta < arc.radius)  // sagitta = r(1 − cos(turn/2)), and 1 − cos = 2·sin²(turn/4)
        onCircle = std::max(onCircle, 0.5 * std::numbers::pi / std::asin(std::sqrt(0.5 * *sagitta / arc.radius)));
    onCircle = std::min(onCircle, static_cast<double>(mostEdgesOfCircle));
    return 2 * std::max(1, static_cast<int>(std::ceil(0.5 * onCircle * arc.sweep / 360.0 - 1e-9)));
}

/// Adds pieces one after another, each starting at the end of the previous one.
class Builder {
public:
    explicit Builder(std::optional<double> sagitta) : sagitta_(sagitta) {}

    void line(const Point& from, const Point& to) { add({from, to, std::nullopt, 1, 0.0, (to - from).norm()}); }

    void arc(const Point& from, const Point& to, const Arc& arc) {
        add({from, to, arc, edgesOf(arc, sagitta_), 0.0, arc.radius * arc.sweep * radiansPerDegree});
    }

    TunnelProfile profile;

private:
    void add(ProfilePiece piece) {
        if (!(piece.length > 0.0)) return;
        piece.begin = profile.length;
        profile.length += piece.length;
        profile.pieces.push_back(std::move(piece));
    }

    std::optional<double> sagitta_;
};

TunnelProfile built(const CircleShape& s, std::optional<double> sagitta) {
    Builder builder(sagitta);
    const Arc round{s.center, 0.5 * s.diameter, -90.0, 360.0};
    builder.arc(onArc(round, -90.0), onArc(round, -90.0), round);
    return builder.profile;
}

/// Floor, straight walls and the arch above them.
TunnelProfile walledArch(const Point& center, double width, double wallHeight, double rise, const Arc& arch,
                         std::optional<double> sagitta) {
    const double x = 0.5 * width, floor = -0.5 * (wallHeight + rise), spring = floor + wallHeight;
    const Point left = center + Point(-x, spring), right = center + Point(x, spring);
    const Point bottomLeft = center + Point(-x, floor), bottomRight = center + Point(x, floor);
    Builder builder(sagitta);
    builder.line(bottomLeft, bottomRight);
    if (wallHeight > 0.0) builder.line(bottomRight, right);
    builder.arc(right, left, arch);
    if (wallHeight > 0.0) builder.line(left, bottomLeft);
    return builder.profile;
}

TunnelProfile built(const DShape& s, std::optional<double> sagitta) {
    const double rise = 0.5 * s.width, walls = s.height - rise;
    const Arc arch{s.center + Point(0.0, walls - 0.5 * s.height), rise, 0.0, 180.0};
    return walledArch(s.center, s.width, walls, rise, arch, sagitta);
}

TunnelProfile built(const ArchedShape& s, std::optional<double> sagitta) {
    const double radius = (0.25 * s.width * s.width + s.rise * s.rise) / (2.0 * s.rise);
    const double half = 2.0 * std::atan2(2.0 * s.rise, s.width) / radiansPerDegree;
    const double crown = 0.5 * (s.wallHeight + s.rise);
    const Arc arch{s.center + Point(0.0, crown - radius), radius, 90.0 - half, 2.0 * half};
    return walledArch(s.center, s.width, s.wallHeight, s.rise, arch, sagitta);
}

TunnelProfile built(const HorseshoeShape& s, std::optional<double> sagitta) {
    const double w = s.width, depth = s.height - 0.5 * w, floor = -0.5 * s.height, spring = floor + depth;
    const double x = std::sqrt((w - depth) * (w + depth)) - 0.5 * w;
    const double turn = std::asin(depth / w) / radiansPerDegree;
    const Point bottomLeft = s.center + Point(-x, floor), bottomRight = s.center + Point(x, floor);
    const Point left = s.center + Point(-0.5 * w, spring), right = s.center + Point(0.5 * w, spring);
    Builder builder(sagitta);
    builder.line(bottomLeft, bottomRight);
    if (depth > 0.0) builder.arc(bottomRight, right, {left, w, -turn, turn});
    builder.arc(right, left, {s.center + Point(0.0, spring), 0.5 * w, 0.0, 180.0});
    if (depth > 0.0) builder.arc(left, bottomLeft, {right, w, 180.0, turn});
    return builder.profile;
}

TunnelProfile built(const PolygonShape& s, std::optional<double> sagitta) {
    Builder builder(sagitta);
    const std::vector<Point> corners = counterClockwise(s.points);
    for (std::size_t i = 0; i < corners.size(); ++i) builder.line(corners[i], corners[(i + 1) % corners.size()]);
    return builder.profile;
}

}  // namespace

TunnelProfile tunnelProfile(const ProfileShape& shape, std::optional<double> sagitta) {
    assert(!sagitta || *sagitta > 0.0);
    return std::visit([&](const auto& s) { return built(s, sagitta); }, shape);
}

std::vector<Point> outline(const TunnelProfile& profile) {
    std::vector<Point> corners;
    for (const ProfilePiece& piece : profile.pieces)
        for (int i = 0; i < piece.edges; ++i) corners.push_back(cornerOf(piece, i));
    return corners;
}

Point cornerOf(const ProfilePiece& piece, int i) {
    if (i == 0) return piece.from;
    if (i == piece.edges) return piece.to;
    return onArc(*piece.arc, piece.arc->start + piece.arc->sweep * i / piece.edges);
}

}  // namespace keyblock
