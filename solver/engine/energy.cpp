// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energies of a state: what is stored, what moves, and the balance over all
// that was booked since the start.
#include "solver/engine/step_build.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace keyblock {

StoredEnergy storedEnergy(const Model& model, const State& state) {
    StoredEnergy energy;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Eigen::Vector3d stress = frameStress(model.blocks[i], state.blocks[i]);
        energy.strain += 0.5 * model.blocks[i].area * model.thickness *
                         stress.dot(model.blocks[i].elasticity.inverse() * stress);
    }
    StepProblem links;
    links.blocks = static_cast<int>(model.blocks.size());
    links.nodes = model.nodes;
    addContactLinks(model, state, false, links);
    addHeldPoints(model, state, links);
    for (std::size_t b = 0; b < model.bolts.size(); ++b) addBoltLinks(model, state, static_cast<int>(b), links);
    for (const Link& link : links.links) {
        const double stored = link.law.share * storedEnergy(link.law, respond(link.law, link.strain).force);
        const bool contact = link.kind == LinkKind::Normal || link.kind == LinkKind::Friction;
        (contact ? energy.contact : link.kind == LinkKind::Support ? energy.strain : energy.bolt) += stored;
    }
    return energy;
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

Energy energyOf(const Model& model, const State& state) {
    const StoredEnergy stored = storedEnergy(model, state);
    Energy e;
    e.kinetic = kineticEnergy(model, state);
    e.strain = stored.strain;
    e.contact = stored.contact;
    e.bolt = stored.bolt;
    e.friction = state.energy.friction;
    e.plastic = state.energy.plastic;
    e.released = state.energy.released;
    e.damped = state.energy.damped;
    e.external = state.energy.external;
    const double left = e.external + state.startEnergy -
                        (e.kinetic + e.strain + e.contact + e.bolt + e.friction + e.plastic + e.released + e.damped);
    double largest = std::abs(state.startEnergy);
    for (double term : {e.kinetic, e.strain, e.contact, e.bolt, e.friction, e.plastic, e.released, e.damped, e.external})
        largest = std::max(largest, std::abs(term));
    e.balanceError = largest > 0.0 ? left / largest : 0.0;
    return e;
}

void resetEnergyStart(const Model& model, State& state) {
    const Energy e = energyOf(model, state);
    state.startEnergy = e.kinetic + e.strain + e.contact + e.bolt + e.friction + e.plastic + e.released + e.damped -
                        e.external;
}

}  // namespace keyblock
