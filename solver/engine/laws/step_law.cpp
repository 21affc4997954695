// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/laws/step_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

/// Mean of max(low, min(x, high)) for x from `a` to `b`, summed over its linear pieces to avoid cancellation.
double clippedMean(double a, double b, double low, double high) {
    const double from = std::min(a, b), to = std::max(a, b);
    const double inFrom = std::clamp(from, low, high), inTo = std::clamp(to, low, high);
    double sum = 0.5 * (inFrom + inTo) * (inTo - inFrom);
    if (from < low) sum += low * (std::min(to, low) - from);
    if (to > high) sum += high * (to - std::max(from, high));
    return sum / (to - from);
}

/// Average of a force that is clipped to [low, high] while its trial value goes from `a` to `b`.
LawResponse clippedAverage(double a, double b, double low, double high, double stiffness) {
    const bool inside = std::min(a, b) >= low && std::max(a, b) <= high;
    if (inside) return {0.5 * (a + b), 0.5 * stiffness};
    if (std::max(a, b) <= low) return {low, 0.0};
    if (std::min(a, b) >= high) return {high, 0.0};
    const double mean = clippedMean(a, b, low, high);
    return {mean, std::clamp((std::clamp(b, low, high) - mean) / (b - a), 0.0, 1.0) * stiffness};
}

/// Work dissipated by friction or plastic flow along the path, not multiplied by `share`.
double usedWork(const Law& law, double carried, double force, double before, double after) {
    switch (law.kind) {
        case LawKind::Capped:
            if (law.stiffness <= 0.0) return 0.0;
            if (law.rigid) return std::abs(force) >= law.limit ? force * (after - before) : 0.0;
            return force * ((after - force / law.stiffness) - (before - carried / law.stiffness));
        case LawKind::Curve: return respond(*law.curve, law.state, after).plasticWork;
        case LawKind::Constant: return force * (after - before);
        default: return 0.0;
    }
}

}  // namespace

LawResponse averageResponse(const Law& law, double before, double after) {
    const double a = law.stiffness * (before - law.offset), b = law.stiffness * (after - law.offset);
    switch (law.kind) {
        case LawKind::Linear: return {0.5 * (a + b), 0.5 * law.stiffness};
        case LawKind::Gap: return clippedAverage(a, b, -std::numeric_limits<double>::infinity(), 0.0, law.stiffness);
        case LawKind::Capped: return clippedAverage(a, b, -law.limit, law.limit, law.stiffness);
        case LawKind::Constant: return {law.limit, 0.0};
        case LawKind::Curve: {
            const double mean = averageForce(*law.curve, law.state, before, after);
            const BackboneResponse end = respond(*law.curve, law.state, after);
            if (end.state == law.state || after == before) return {mean, 0.5 * end.tangent};
            return {mean, std::clamp((end.force - mean) / (after - before), 0.0, law.curve->modulus)};
        }
        case LawKind::Viscous: return respond(law, after);
    }
    return {};
}

double lawLoss(const Law& law, double before, double after, const StepRule& rule) {
    const double carried = carriedForce(law, before), end = respond(law, after).force;
    const double work = respondOverStep(law, before, after, rule).force * (after - before);
    const double stored = storedEnergy(law, end) - storedEnergy(law, carried);
    return law.share * (work - stored - usedWork(law, carried, end, before, after));
}

PathWork pathWork(const Law& law, const PathStart& start, double after) {
    const double end = respond(law, after).force, way = after - start.strain;
    PathWork path{end, 0.0};
    double used = usedWork(law, start.force, end, start.strain, after);
    double first = start.force;  // the force at the start of the path
    if (law.kind == LawKind::Capped && law.stiffness > 0.0) {
        if (!law.rigid) first = std::clamp(start.force, -start.limit, start.limit);
        const double sign = end < 0.0 ? -1.0 : 1.0;
        const double trial = sign * law.stiffness * (after - law.offset);
        const double room = start.limit - sign * start.force;
        const double closes = (trial - sign * start.force) - (law.limit - start.limit);
        const bool atOnce = law.rigid || room <= 0.0;
        const double onset = atOnce ? 0.0 : closes > room ? room / closes : 1.0;  // fraction of the path
        const bool slides = law.rigid ? std::abs(end) >= law.limit : trial > law.limit;
        if (slides) path.slipForce = sign * (law.limit + 0.5 * (1.0 - onset) * (start.limit - law.limit));
        used = law.rigid ? (slides ? path.slipForce * way : 0.0)
                         : path.slipForce * ((after - end / law.stiffness) - law.offset);  // as the zero point moves
    }
    const double stored = storedEnergy(law, end) - storedEnergy(law, start.force);
    path.surplus = law.share * (0.5 * (first + end) * way - stored - used);
    return path;
}

}  // namespace keyblock
