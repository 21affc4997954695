// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of a link in a few numbers, for loops that ask all links many times: a
// straight line between two limits, where the step takes the force at its end. Any
// other law is bent, and has to be asked itself.
#pragma once

#include "solver/engine/step/step_problem.h"

#include <algorithm>
#include <limits>

namespace keyblock {

struct FlatLaw {
    double stiffness = 0.0, offset = 0.0;
    double low = 0.0, high = 0.0;  // of the force, before its share [N]; `high` alone, without `factor`, where it follows
    double factor = 0.0;  // a limit that follows rises by this times the push of the link that it follows
    bool follows = false;
    bool bent = false;

    /// Limit under the force of the link that it follows [N].
    double limit(double from) const { return high + std::max(0.0, -factor * from); }
};

/// `std::clamp` by minimum and maximum: no processor can foretell branches by the states of links.
inline double clipped(double x, double low, double high) {
    const double above = x < low ? low : x;
    return high < above ? high : above;
}

/// The law of a link as it is.
inline FlatLaw flatLaw(const StepProblem& problem, const Link& link) {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const Law& law = link.law;
    FlatLaw flat{law.stiffness, law.offset, -unlimited, unlimited};
    if (law.kind == LawKind::Gap) flat.high = 0.0;
    if (law.kind == LawKind::Capped) flat.low = -law.limit, flat.high = law.limit;
    if (law.kind == LawKind::Constant) flat.low = flat.high = law.limit;
    const bool weighted = ofContact(link.kind) && problem.contactShare != 1.0;
    flat.bent = weighted || law.kind == LawKind::Curve || ruleOf(problem, link).rule != ForceRule::End;
    return flat;
}

/// The same where its limit follows another link.
inline FlatLaw flatLaw(const StepProblem& problem, const LimitPair& pair) {
    const Link& link = problem.links[static_cast<std::size_t>(pair.limited)];
    FlatLaw flat = flatLaw(problem, link);
    flat.follows = link.law.kind == LawKind::Capped && pair.rule == LimitPair::Rule::Push;
    flat.bent = flat.bent || !flat.follows;
    flat.factor = pair.factor;
    flat.high = pair.base;
    return flat;
}

}  // namespace keyblock
