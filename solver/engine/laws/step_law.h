// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What force a law gives to a whole step. A scheme may take the force at the
// step's end, the mean along the strain that it passes (the discrete gradient,
// which keeps energy), or a mix of the two. All three rise with
// the strain at the end, so the step stays convex (theory, "Time").
#pragma once

#include "solver/engine/laws/law.h"

namespace keyblock {

enum class ForceRule { End, Average, Blend };

struct StepRule {
    ForceRule rule = ForceRule::End;
    double end = 1.0;  // Blend: weight of the end against the start, from ½ to 1, as of a straight law
};

/// Force that the law carried when the step began. A friction limit may have fallen since: the offset remembers.
inline double carriedForce(const Law& law, double before) {
    return law.kind == LawKind::Capped ? law.stiffness * (before - law.offset) : respond(law, before).force;
}

/// Mean of the force along the strain from `before` to `after`, and its tangent by `after`.
LawResponse averageResponse(const Law& law, double before, double after);

/// Force and tangent of a step that goes from strain `before` to `after`; shares are left to the caller.
inline LawResponse respondOverStep(const Law& law, double before, double after, const StepRule& rule) {
    if (rule.rule == ForceRule::End || law.kind == LawKind::Viscous) return respond(law, after);
    if (rule.rule == ForceRule::Average) return averageResponse(law, before, after);
    const LawResponse end = respond(law, after), mean = averageResponse(law, before, after);
    const double late = 2.0 * rule.end - 1.0;  // a part that loses and a part that keeps energy, and none that gives it
    return {late * end.force + (1.0 - late) * mean.force, late * end.tangent + (1.0 - late) * mean.tangent};
}

/// What the law lost to the scheme [J]: work of the step's force, less what was stored and what friction or plastic
/// flow used (theory, "Energies").
double lawLoss(const Law& law, double before, double after, const StepRule& rule);

/// Where a path began. The force is given because that of a rigid law does not follow from strain.
struct PathStart {
    double strain = 0.0;
    double force = 0.0;  // before share
    double limit = 0.0;  // of friction
};

/// A law between two equilibria, on a straight path of strain along which the friction limit goes evenly from the
/// start's to the law's own.
struct PathWork {
    double slipForce = 0.0;  // mean force while it slid; the force at the end where it did not
    double surplus = 0.0;  // trapezium of the forces that act at both ends, less what was stored and used; times share [J]
};
PathWork pathWork(const Law& law, const PathStart& start, double after);

}  // namespace keyblock
