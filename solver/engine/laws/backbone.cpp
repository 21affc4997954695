// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/laws/backbone.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {
namespace {

constexpr double flattestPiece = 1e-7;  // minimum slope of a piece, over the first slope

/// The piece of the yield curve that starts at or before `accumulated`.
std::size_t pieceAt(const Backbone& b, double accumulated) {
    const auto after = std::upper_bound(b.plastic.begin(), b.plastic.end(), accumulated);
    const std::size_t piece = std::max<std::ptrdiff_t>(0, after - b.plastic.begin() - 1);
    return std::min(piece, b.plastic.size() - 1);
}

/// Slope of the yield force over the plastic strain on a piece; past the last point, the minimum slope.
double hardening(const Backbone& b, std::size_t piece) {
    if (piece + 1 >= b.plastic.size()) return flattestPiece * b.modulus;
    return (b.force[piece + 1] - b.force[piece]) / (b.plastic[piece + 1] - b.plastic[piece]);
}

}  // namespace

Backbone Backbone::of(const std::vector<std::pair<double, double>>& curve, double strainScale, double forceScale) {
    Backbone b;
    std::size_t first = 0;
    while (first < curve.size() && curve[first].first <= 0.0) ++first;
    assert(first > 0 && first < curve.size() && curve[first].second > 0.0);
    b.modulus = curve[first].second * forceScale / (curve[first].first * strainScale);
    b.plastic.push_back(0.0);
    b.force.push_back(curve[first].second * forceScale);
    double strain = curve[first].first * strainScale;
    for (std::size_t i = first + 1; i < curve.size(); ++i) {
        const double stretch = curve[i].first * strainScale - strain;
        double rise = curve[i].second * forceScale - b.force.back();
        const double least = flattestPiece * b.modulus * stretch;
        if (std::abs(rise) < least) rise = least;
        b.force.push_back(b.force.back() + rise);
        b.plastic.push_back(b.plastic.back() + stretch - rise / b.modulus);
        strain += stretch;
    }
    b.lastStrain = strain;
    return b;
}

Backbone Backbone::strengthened(double factor) const {
    Backbone b = *this;
    for (double& f : b.force) f *= factor;
    return b;
}

double yieldForce(const Backbone& b, double accumulated) {
    if (accumulated == 0.0 && b.plastic.size() > 1 && b.plastic[1] > 0.0) return b.force.front();  // most of a bar
    const std::size_t piece = pieceAt(b, accumulated);
    return b.force[piece] + hardening(b, piece) * (accumulated - b.plastic[piece]);
}

BackboneResponse respond(const Backbone& b, const BackboneState& state, double strain) {
    BackboneResponse r;
    r.state = state;
    r.force = b.modulus * (strain - state.plastic);
    r.tangent = b.modulus;
    if (std::abs(r.force) <= yieldForce(b, state.accumulated)) return r;

    const double sign = r.force > 0.0 ? 1.0 : -1.0;
    const double trial = std::abs(r.force);
    double accumulated = state.accumulated;
    double yield = yieldForce(b, accumulated);
    std::size_t piece = pieceAt(b, accumulated);
    for (;;) {  // walk along the pieces until trial − E·Δ meets the yield force
        const double h = hardening(b, piece);
        const double step = (trial - b.modulus * (accumulated - state.accumulated) - yield) / (b.modulus + h);
        const bool last = piece + 1 >= b.plastic.size();
        if (last || accumulated + step <= b.plastic[piece + 1]) {
            r.plasticWork += step * (yield + 0.5 * h * step);
            accumulated += step;
            yield += h * step;
            r.tangent = b.modulus * h / (b.modulus + h);
            break;
        }
        const double room = b.plastic[piece + 1] - accumulated;
        r.plasticWork += room * (yield + 0.5 * h * room);
        accumulated = b.plastic[piece + 1];
        yield = b.force[++piece];
    }
    r.force = sign * yield;
    r.state.accumulated = accumulated;
    r.state.plastic += sign * (accumulated - state.accumulated);
    return r;
}

double averageForce(const Backbone& b, const BackboneState& state, double from, double to) {
    const BackboneResponse end = respond(b, state, to);
    const double start = b.modulus * (from - state.plastic);
    if (end.state == state) return 0.5 * (start + end.force);
    const double sign = end.force > 0.0 ? 1.0 : -1.0;
    const double first = yieldForce(b, state.accumulated), last = std::abs(end.force);
    const double carried = std::min(sign * start, first);
    const double elastic = (first - carried) / b.modulus;  // stretch up to the yield force
    const double stretch = elastic + (end.state.accumulated - state.accumulated) + (last - first) / b.modulus;
    if (stretch <= 0.0) return end.force;
    const double work = 0.5 * elastic * (carried + first) + end.plasticWork +
                        0.5 * (last - first) * (last + first) / b.modulus;
    return sign * work / stretch;
}

}  // namespace keyblock
