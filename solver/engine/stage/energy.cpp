// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energies of a state: what is stored, what moves, and the balance over all
// that was booked since the start.
#include "solver/engine/glue.h"
#include "solver/engine/stage/step_build.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace keyblock {
namespace {

constexpr double roundOffEnergy = 1e-18;  // over E · volume: less is no energy to balance

StepProblem noLinks(const Model& model) {
    StepProblem problem;
    problem.blocks = static_cast<int>(model.blocks.size());
    problem.nodes = model.nodes;
    return problem;
}

double heldBy(const StepProblem& problem) {
    double energy = 0.0;
    for (const Link& link : problem.links)
        energy += link.law.share * storedEnergy(link.law, respond(link.law, link.strain).force);
    return energy;
}

}  // namespace

StoredEnergy storedEnergy(const Model& model, const State& state) {
    StoredEnergy energy;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        if (state.blocks[i].absent) continue;
        const Eigen::Vector3d stress = frameStress(model.blocks[i], state.blocks[i]);
        energy.strain += 0.5 * model.blocks[i].area * model.thickness *
                         stress.dot(model.blocks[i].elasticity.inverse() * stress);
    }
    StepProblem contacts = noLinks(model), held = noLinks(model);
    addContactLinks(model, state, false, contacts);
    addHeldPoints(model, state, held);
    addGlueLinks(model, state, 0.0, held);
    energy.contact = heldBy(contacts);
    energy.strain += heldBy(held);
    for (std::size_t b = 0; b < model.bolts.size(); ++b) energy.bolt += boltEnergy(model, state, static_cast<int>(b));
    return energy;
}

double boltEnergy(const Model& model, const State& state, int bolt) {
    StepProblem links = noLinks(model);
    addBoltLinks(model, state, bolt, links);
    return heldBy(links);
}

double kineticEnergy(const Model& model, const State& state) {
    double energy = 0.0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Vector6& v = state.blocks[i].velocity;
        energy += 0.5 * v.dot(model.blocks[i].massMatrix * v);
    }
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        const BoltModel& bolt = model.bolts[b];
        for (std::size_t e = 0; e < bolt.elements.size(); ++e) {
            const double mass = bolt.share * lumpedMass(bolt.section, bolt.elements[e].length);
            const double inertia = bolt.share * lumpedInertia(bolt.section, bolt.elements[e].length);
            for (std::size_t n : {e, e + 1}) {
                const Eigen::Vector3d& v = state.bolts[b].nodes[n].velocity;
                energy += 0.5 * (mass * v.head<2>().squaredNorm() + inertia * v[2] * v[2]);
            }
        }
    }
    return energy;
}

double bookedEnergy(const Model& model, const State& state) {
    const StoredEnergy stored = storedEnergy(model, state);
    const EnergyLedger& e = state.energy;
    return kineticEnergy(model, state) + stored.strain + stored.contact + stored.bolt + e.friction + e.plastic +
           e.released + e.damped - e.external;
}

Energy energyOf(const Model& model, const State& state) {
    const StoredEnergy stored = storedEnergy(model, state);
    const EnergyLedger& ledger = state.energy;
    Energy e{kineticEnergy(model, state), stored.strain, stored.contact, stored.bolt, ledger.friction,
             ledger.plastic, ledger.released, ledger.damped, ledger.external, 0.0};
    double largest = std::abs(state.startEnergy);
    for (const BlockModel& block : model.blocks)
        largest = std::max(largest, roundOffEnergy * block.youngsModulus * block.area * model.thickness);
    for (double term : {e.kinetic, e.strain, e.contact, e.bolt, e.friction, e.plastic, e.released, e.damped, e.external})
        largest = std::max(largest, std::abs(term));
    const double left = state.startEnergy - bookedEnergy(model, state);
    e.balanceError = left / largest;
    return e;
}

}  // namespace keyblock
