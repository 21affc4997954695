// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions along the wall of a tunnel. A position within a billionth of the whole length of the end of a piece belongs
// to both adjacent pieces, so that round-off has no influence.
#include "geometry/angle.h"
#include "geometry/segment.h"
#include "geometry/shape/tunnel_profile.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// Fraction of the whole length below which two positions coincide.
constexpr double onePlace = 1e-9;

/// A piece and a position on it.
struct Place {
    std::size_t piece = 0;
    double share = 0.0;  // 0 … 1 along the piece
};

/// `length` reduced to the range from 0 up to, but not including, the whole length.
double wrapped(const TunnelProfile& profile, double length) {
    const double rest = std::fmod(length, profile.length);
    const double positive = rest < 0.0 ? rest + profile.length : rest;
    return positive < profile.length ? positive : 0.0;
}

Place placeAt(const TunnelProfile& profile, double length) {
    const double at = wrapped(profile, length);
    const auto after = std::upper_bound(profile.pieces.begin(), profile.pieces.end(), at,
                                        [](double s, const ProfilePiece& piece) { return s < piece.begin; });
    const auto index = static_cast<std::size_t>(after - profile.pieces.begin()) - 1;
    const ProfilePiece& piece = profile.pieces[index];
    return {index, std::clamp((at - piece.begin) / piece.length, 0.0, 1.0)};
}

double degreesAt(const Arc& arc, double share) { return arc.start + arc.sweep * share; }

Point pointOn(const ProfilePiece& piece, double share) {
    if (!piece.arc) return piece.from + share * (piece.to - piece.from);
    return piece.arc->center + piece.arc->radius * directionOf(degreesAt(*piece.arc, share));
}

Point normalOn(const ProfilePiece& piece, double share) {
    if (piece.arc) return directionOf(degreesAt(*piece.arc, share));
    return -turnLeft((piece.to - piece.from).normalized());
}

/// The position on `piece` that is nearest to `p`, as a fraction of its length.
double nearestShare(const ProfilePiece& piece, const Point& p) {
    if (!piece.arc) return std::clamp(footParameter(piece.from, piece.to, p), 0.0, 1.0);
    const Point out = p - piece.arc->center;
    if (out == Point(0.0, 0.0)) return 0.0;
    const double half = 0.5 * piece.arc->sweep;
    const double degrees = std::atan2(out.y(), out.x()) / radiansPerDegree;
    const double fromMiddle = std::remainder(degrees - piece.arc->start - half, 360.0);
    return 0.5 + 0.5 * std::clamp(fromMiddle / half, -1.0, 1.0);
}

}  // namespace

Point pointAtLength(const TunnelProfile& profile, double length) {
    const Place place = placeAt(profile, length);
    return pointOn(profile.pieces[place.piece], place.share);
}

Point outlinePointAtLength(const TunnelProfile& profile, double length) {
    const Place place = placeAt(profile, length);
    const ProfilePiece& piece = profile.pieces[place.piece];
    if (!piece.arc) return pointOn(piece, place.share);
    const double edges = place.share * piece.edges;
    const double nearest = std::round(edges);
    if (std::abs(edges - nearest) * piece.length <= onePlace * profile.length * piece.edges)
        return cornerOf(piece, static_cast<int>(nearest));
    const int edge = static_cast<int>(std::floor(edges));
    const double half = 0.5 * piece.arc->sweep / piece.edges * radiansPerDegree;
    const double fromMiddle = 2.0 * half * (edges - edge - 0.5);
    const double share = 0.5 + 0.5 * std::tan(fromMiddle) / std::tan(half);
    const Point a = cornerOf(piece, edge), b = cornerOf(piece, edge + 1);
    return a + share * (b - a);
}

Point normalAtLength(const TunnelProfile& profile, double length) {
    const Place place = placeAt(profile, length);
    const std::size_t count = profile.pieces.size();
    const ProfilePiece& piece = profile.pieces[place.piece];
    const Point own = normalOn(piece, place.share);
    const double fromBegin = place.share * piece.length;
    Point other = own;
    if (fromBegin <= onePlace * profile.length)
        other = normalOn(profile.pieces[(place.piece + count - 1) % count], 1.0);
    else if (piece.length - fromBegin <= onePlace * profile.length)
        other = normalOn(profile.pieces[(place.piece + 1) % count], 0.0);
    const Point sum = own + other;
    return sum.norm() > onePlace ? Point(sum.normalized()) : own;
}

double lengthOfNearest(const TunnelProfile& profile, const Point& p) {
    double nearest = 0.0, least = (pointAtLength(profile, 0.0) - p).norm();
    for (const ProfilePiece& piece : profile.pieces) {
        const double share = nearestShare(piece, p);
        const double distance = (pointOn(piece, share) - p).norm();
        if (distance >= least - onePlace * profile.length) continue;
        least = distance;
        nearest = piece.begin + share * piece.length;
    }
    return wrapped(profile, nearest);
}

double lengthBetween(const TunnelProfile& profile, double from, double to, Way way) {
    const double round = wrapped(profile, way == Way::CounterClockwise ? to - from : from - to);
    const double margin = onePlace * profile.length;
    return round <= margin || profile.length - round <= margin ? 0.0 : round;
}

}  // namespace keyblock
