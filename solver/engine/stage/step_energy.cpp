// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/step_energy.h"

#include "solver/engine/stage/energy.h"

#include <cmath>

namespace keyblock {
namespace {

constexpr double countsFrom = 1e-5;  // of the largest energy: less is no error of a step

}  // namespace

bool StepEnergy::leavesMoreThan(double share) const {
    return std::abs(left) > share * lost && std::abs(left) > countsFrom * scale;
}

StepEnergy energyOfStep(const Model& model, const State& before, const State& after) {
    const Energy a = energyOf(model, before), b = energyOf(model, after);
    // generalized-α may give back in one place what it takes in another: each term counts by its amount
    const double lost = std::abs(b.friction - a.friction) + std::abs(b.plastic - a.plastic) +
                        std::abs(b.released - a.released) + std::abs(b.damped - a.damped);
    return {accountedEnergy(b) - accountedEnergy(a), lost, largestEnergy(model, after, b)};
}

}  // namespace keyblock
