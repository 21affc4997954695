// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compact form of a link's law, for loops that evaluate all links many times: a
// straight line between two limits, for steps that use the force at their end. Any
// other law is marked as bent and must be evaluated itself.
#pragma once

#include "solver/engine/step/step_problem.h"

#include <algorithm>
#include <limits>

namespace keyblock {

/// Bounds of the force of such a law, without `Law::share`.
struct FlatBounds {
    double low = 0.0, high = 0.0;  // [N]; `high`: constant part if `follows`
    double factor = 0.0;  // if `follows`: increase of the limit per unit of compression of the normal link
    bool follows = false;  // the limit depends on the force of another link
    bool bent = false;  // not a straight line between two limits: evaluate the law itself

    /// Friction limit [N] if the corresponding normal link has the force `from` [N], compression negative.
    double limit(double from) const { return high + std::max(0.0, -factor * from); }
};

struct FlatLaw {
    double stiffness = 0.0, offset = 0.0;
    FlatBounds bounds;
};

/// Like `std::clamp`, but without branches. The states of links vary too much for branch prediction.
inline double clipped(double x, double low, double high) {
    const double above = x < low ? low : x;
    return high < above ? high : above;
}

/// Compact form of a link's law with its current limit.
inline FlatLaw flatLaw(const StepProblem& problem, const Link& link) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const Law& law = link.law;
    FlatBounds bounds{-unlimited, unlimited};
    if (law.kind == LawKind::Gap) bounds.high = 0.0;
    if (law.kind == LawKind::Capped) bounds.low = -law.limit, bounds.high = law.limit;
    if (law.kind == LawKind::Constant) bounds.low = bounds.high = law.limit;
    const bool weighted = ofContact(link.kind) && problem.contactShare != 1.0;
    bounds.bent = weighted || law.kind == LawKind::Curve || ruleOf(problem, link).rule != ForceRule::End;
    return {law.stiffness, law.offset, bounds};
}

/// Compact form of the law of the link `pair.limited`, whose limit follows the force of the link `pair.from`.
inline FlatLaw flatLaw(const StepProblem& problem, const LimitPair& pair) {
    const Link& link = problem.links[pair.limited];
    FlatLaw flat = flatLaw(problem, link);
    FlatBounds& bounds = flat.bounds;
    bounds.follows = link.law.kind == LawKind::Capped && pair.rule == LimitPair::Rule::Push;
    bounds.bent = bounds.bent || !bounds.follows;
    bounds.factor = pair.factor;
    bounds.high = pair.base;
    return flat;
}

}  // namespace keyblock
