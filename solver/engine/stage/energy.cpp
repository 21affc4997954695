// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/energy.h"

#include "solver/engine/stage/carriers.h"
#include "solver/engine/time/mass.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double roundOffEnergy = 1e-18;  // over E · volume: smaller energies are round-off

double strainEnergy(const Model& model, const BlockModel& block, const BlockMotion& motion) {
    const Eigen::Vector3d stress = frameStress(block, motion);
    return 0.5 * block.area * model.thickness * stress.dot(block.compliance * stress);
}

double blockEnergy(const Model& model, const State& state) {
    double energy = 0.0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        if (!state.blocks[i].absent) energy += strainEnergy(model, model.blocks[i], state.blocks[i]);
    return energy;
}

}  // namespace

double energyOfBlock(const Model& model, int row, const BlockMotion& motion) {
    const BlockModel& block = model.blocks[row];
    return 0.5 * motion.velocity.dot(block.massMatrix * motion.velocity) + strainEnergy(model, block, motion);
}

StoredEnergy storedEnergy(const Model& model, const State& state) {
    StoredEnergy energy;
    for (auto carrier = carriers.rbegin(); carrier != carriers.rend(); ++carrier)
        if ((*carrier)->addStoredEnergy) (*carrier)->addStoredEnergy(model, state, energy);
    energy.strain += blockEnergy(model, state);
    return energy;
}

Energy energyOf(const Model& model, const State& state) {
    const StoredEnergy stored = storedEnergy(model, state);
    const EnergyLedger& ledger = state.energy;
    Energy e{kineticEnergy(model, state), stored.strain, stored.contact, stored.bolt, ledger.friction,
             ledger.plastic, ledger.released, ledger.damped, ledger.external, 0.0};
    e.balanceError = (state.startEnergy - accountedEnergy(e)) / largestEnergy(model, state, e);
    return e;
}

double accountedEnergy(const Energy& e) {
    return e.kinetic + e.strain + e.contact + e.bolt + e.friction + e.plastic + e.released + e.damped - e.external;
}

double accountedEnergy(const Model& model, const State& state) { return accountedEnergy(energyOf(model, state)); }

double largestEnergy(const Model& model, const State& state, const Energy& e) {
    double largest = std::abs(state.startEnergy);
    for (const BlockModel& block : model.blocks)
        largest = std::max(largest, roundOffEnergy * block.youngsModulus * block.area * model.thickness);
    for (double term : {e.kinetic, e.strain, e.contact, e.bolt, e.friction, e.plastic, e.released, e.damped, e.external})
        largest = std::max(largest, std::abs(term));
    return largest;
}

}  // namespace keyblock
