// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/energy_limit.h"

#include "solver/engine/stage/energy.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double noiseShare = 1e-3;  // fraction of the largest energy of the run: smaller errors are ignored
// fraction of the stiffest block: errors below its strain energy at `noiseStrain` are ignored
constexpr double noiseVolume = 1e-9;
constexpr double noiseStrain = 1e-4;

double noiseOf(const Model& model) {
    double stiffest = 0.0;
    for (const BlockModel& block : model.blocks)
        stiffest = std::max(stiffest, block.youngsModulus * block.area * model.thickness);
    return noiseVolume * stiffest * noiseStrain * noiseStrain;
}

int mostGained(const Model& model, const State& state, const std::vector<BlockMotion>& start) {
    int most = -1;
    double largest = 0.0;
    for (std::size_t i = 0; i < model.blocks.size() && i < start.size(); ++i) {
        const double gained = energyOfBlock(model, static_cast<int>(i), state.blocks[i]) -
                              energyOfBlock(model, static_cast<int>(i), start[i]);
        if (!(gained <= largest)) most = static_cast<int>(i), largest = gained;
        if (std::isnan(gained)) break;
    }
    return most;
}

}  // namespace

void markEnergy(const Model& model, const State& state, EnergyMark& mark) {
    const Energy energy = energyOf(model, state);
    mark.left = state.startEnergy - accountedEnergy(energy);
    mark.largest = std::max(mark.largest, largestEnergy(model, state, energy));
}

std::optional<EnergyExcess> energyExcess(const Model& model, const State& state, const std::vector<BlockMotion>& start,
                                         double allowed, EnergyMark& mark) {
    const Energy energy = energyOf(model, state);
    const double largest = largestEnergy(model, state, energy);
    mark.largest = std::max(mark.largest, largest);
    const double left = std::abs(state.startEnergy - accountedEnergy(energy) - mark.left);
    if (left <= std::max({allowed * largest, noiseShare * mark.largest, noiseOf(model)})) return {};
    return EnergyExcess{left / largest, mostGained(model, state, start)};
}

}  // namespace keyblock
