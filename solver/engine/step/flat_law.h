// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compact form of a link's law, for loops that evaluate all links many times: a
// straight line between two limits, for steps that use the force at their end. A curve
// is such a line up to its yield force. Any other law is marked as bent and must be
// evaluated itself.
#pragma once

#include "solver/engine/step/step_problem.h"

#include <algorithm>
#include <limits>

namespace keyblock {

/// Bounds of the force of such a law, without `Law::share`.
struct FlatBounds {
    double low = 0.0, high = 0.0;  // [N]; `high`: constant part if `follows`
    double factor = 0.0;  // if `follows`: increase of the limit per unit of compression of the normal link
    bool follows = false;  // the limit depends on the force of the previous link
    bool yields = false;  // beyond the bounds the force is not constant: evaluate the law itself there
    bool bent = false;  // not a straight line between two limits: evaluate the law itself

    /// Friction limit [N] if the corresponding normal link has the force `from` [N], compression negative.
    double limit(double from) const { return high + std::max(0.0, -factor * from); }
};

struct FlatLaw {
    double stiffness = 0.0, offset = 0.0;  // of the line: for a curve, of its first piece; for a constant force, zero
    double beyond = 0.0;  // tangent beyond the bounds [N/m]
    double share = 1.0;  // `Law::share`
    FlatBounds bounds;
};

/// Like `std::clamp`, but without branches. The states of links vary too much for branch prediction.
inline double clipped(double x, double low, double high) {
    const double above = x < low ? low : x;
    return high < above ? high : above;
}

/// True if the law itself has to be evaluated at this strain.
inline bool isBentAt(const FlatLaw& law, double strain) {
    if (!law.bounds.yields) return law.bounds.bent;
    const double trial = law.stiffness * (strain - law.offset);
    return law.bounds.bent || trial < law.bounds.low || law.bounds.high < trial;
}

/// Force of a law that is not bent at this strain, if its bounds do not follow another link.
inline double forceOf(const FlatLaw& law, double strain) {
    return clipped(law.stiffness * (strain - law.offset), law.bounds.low, law.bounds.high);
}

/// Force and tangent of a law that is not bent at this strain, if its force is limited to the range from `low` to `high`.
inline LawResponse respond(const FlatLaw& law, double strain, double low, double high) {
    const double trial = law.stiffness * (strain - law.offset);
    const bool inside = !(trial < low) && !(high < trial);
    return {clipped(trial, low, high), inside ? law.stiffness : law.beyond};
}

/// Compact form of a link's law with its current limit.
inline FlatLaw flatLaw(const StepProblem& problem, const Link& link) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const Law& law = link.law;
    FlatLaw flat{law.stiffness, law.offset, 0.0, law.share, {-unlimited, unlimited}};
    FlatBounds& bounds = flat.bounds;
    const bool weighted = ofContact(link.kind) && problem.contactShare != 1.0;
    bounds.bent = weighted || ruleOf(problem, link).rule != ForceRule::End;
    switch (law.kind) {
        case LawKind::Linear:
        case LawKind::Viscous: break;
        case LawKind::Gap: bounds.high = 0.0; break;
        case LawKind::Capped:
            bounds.low = -law.limit, bounds.high = law.limit;
            flat.beyond = law.leastTangent * law.stiffness;
            break;
        case LawKind::Constant:
            bounds.low = bounds.high = law.limit;
            flat.stiffness = 0.0;
            break;
        case LawKind::Curve:
            flat.stiffness = law.curve->modulus, flat.offset = law.state.plastic;
            bounds.high = yieldForce(*law.curve, law.state.accumulated), bounds.low = -bounds.high;
            bounds.yields = true;
            break;
    }
    return flat;
}

/// Compact form of the law of the link `pair.limited`, whose limit follows the force of the link `pair.from`. It is
/// bent unless that is the previous link.
inline FlatLaw flatLaw(const StepProblem& problem, const LimitPair& pair) {
    const Link& link = problem.links[pair.limited];
    FlatLaw flat = flatLaw(problem, link);
    FlatBounds& bounds = flat.bounds;
    bounds.follows = link.law.kind == LawKind::Capped && pair.rule == LimitPair::Rule::Push &&
                     pair.from + 1 == pair.limited;
    bounds.bent = bounds.bent || !bounds.follows;
    bounds.factor = pair.factor;
    bounds.high = pair.base;
    return flat;
}

}  // namespace keyblock
