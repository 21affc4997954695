// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Force of a law over a whole step. A time scheme may use the force at the end of the
// step, the mean force along the strain path (the discrete gradient, which conserves
// energy), or a combination of the two. All three increase with the strain at the end,
// so the step remains convex (theory, "Time").
#pragma once

#include "solver/engine/laws/law.h"

namespace keyblock {

enum class ForceRule { End, Average, Blend };

struct StepRule {
    ForceRule rule = ForceRule::End;
    double end = 1.0;  // for Blend: weight of the end relative to the start for a linear law, from ½ to 1
};

/// Force of the law at the start of the step, where the strain is `before`. The friction limit is not applied, because
/// it may have decreased since this force was accepted.
inline double carriedForce(const Law& law, double before) {
    return law.kind == LawKind::Capped ? law.stiffness * (before - law.offset) : respond(law, before).force;
}

/// Mean force while the strain changes from `before` to `after`, and its derivative with respect to `after`.
LawResponse averageResponse(const Law& law, double before, double after);

/// Force that `rule` gives for a step from strain `before` to strain `after`, and its derivative with respect to
/// `after`. Neither is multiplied by `Law::share`.
inline LawResponse respondOverStep(const Law& law, double before, double after, const StepRule& rule) {
    if (rule.rule == ForceRule::End || law.kind == LawKind::Viscous) return respond(law, after);
    if (rule.rule == ForceRule::Average) return averageResponse(law, before, after);
    const LawResponse end = respond(law, after), mean = averageResponse(law, before, after);
    const double late = 2.0 * rule.end - 1.0;  // a dissipative and a conserving part, so that no energy is generated
    return {late * end.force + (1.0 - late) * mean.force, late * end.tangent + (1.0 - late) * mean.tangent};
}

/// Energy that the time scheme dissipates in the law over a step [J]: the work of the force that `rule` gives minus the
/// increase in stored energy and the work of friction or plastic flow (theory, "Energies").
double lawLoss(const Law& law, double before, double after, const StepRule& rule);

/// State of a law at the start of a strain path. The force is stored because it does not follow from the strain if the
/// law is rigid.
struct PathStart {
    double strain = 0.0;
    double force = 0.0;  // not multiplied by `Law::share`
    double limit = 0.0;  // friction limit
};

/// Work done by the force of a law between two equilibria. The strain is assumed to vary linearly, as is the friction
/// limit, from `PathStart::limit` to `Law::limit`.
struct PathWork {
    double slipForce = 0.0;  // mean force while sliding; the force at the end if it did not slide
    double surplus = 0.0;  // trapezoidal work of the forces at both ends minus stored and dissipated energy [J]
};
PathWork pathWork(const Law& law, const PathStart& start, double after);

}  // namespace keyblock
