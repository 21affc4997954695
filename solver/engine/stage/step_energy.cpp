// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/step_energy.h"

#include "solver/engine/stage/energy.h"
#include "solver/engine/step/phase.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

// fraction of the largest energy: smaller losses are not an impact, smaller errors are ignored
constexpr double countsFrom = 1e-5;

bool isInContact(const State& state) {
    return std::any_of(state.contacts.begin(), state.contacts.end(), [](const Contact& c) { return c.normalForce > 0.0; });
}

}  // namespace

bool StepEnergy::leavesMoreThan(double share) const {
    const double least = countsFrom * scale;
    return lost > least && std::abs(left) > std::max(share * lost, least);
}

StepEnergy energyOfStep(const Model& model, const State& before, const State& after) {
    const PhaseScope phase(Phase::Accept);
    if (!isInContact(before) && !isInContact(after)) return {};
    const Energy a = energyOf(model, before), b = energyOf(model, after);
    // generalized-α may return energy to one term and take it from another, so each term counts by its magnitude
    const double lost = std::abs(b.friction - a.friction) + std::abs(b.plastic - a.plastic) +
                        std::abs(b.released - a.released) + std::abs(b.damped - a.damped);
    return {accountedEnergy(b) - accountedEnergy(a), lost, largestEnergy(model, after, b)};
}

}  // namespace keyblock
