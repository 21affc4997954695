// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/time/mass.h"

#include "solver/engine/step/step_problem.h"

#include <Eigen/Cholesky>

namespace keyblock {

Eigen::VectorXd velocitiesOf(const Model& model, const State& state) {
    Eigen::VectorXd velocity(6 * static_cast<Eigen::Index>(model.blocks.size()) + 3 * model.nodes);
    Eigen::Index at = 0;
    for (const BlockMotion& block : state.blocks) {
        velocity.segment<6>(at) = block.velocity;
        at += 6;
    }
    for (const BoltMotion& bolt : state.bolts)
        for (const BoltNode& node : bolt.nodes) {
            velocity.segment<3>(at) = node.velocity;
            at += 3;
        }
    return velocity;
}

Eigen::VectorXd accelerationsOf(const Model& model, const State& state) {
    const auto n = 6 * static_cast<Eigen::Index>(model.blocks.size()) + 3 * model.nodes;
    if (state.acceleration.empty()) return Eigen::VectorXd::Zero(n);
    return Eigen::Map<const Eigen::VectorXd>(state.acceleration.data(), n);
}

Eigen::Vector3d nodeMass(const BoltModel& bolt, std::size_t node) {
    Eigen::Vector3d mass = Eigen::Vector3d::Zero();
    for (std::size_t e : {node - 1, node}) {
        if (e >= bolt.elements.size()) continue;
        const double translation = lumpedMass(bolt.section, bolt.elements[e].length);
        mass += bolt.share *
                Eigen::Vector3d(translation, translation, lumpedInertia(bolt.section, bolt.elements[e].length));
    }
    return mass;
}

Eigen::VectorXd byMass(const Model& model, const StepProblem& problem, const Eigen::VectorXd& force) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(force.size());
    const auto known = [&](Eigen::Index i) { return problem.known[i] != 0; };
    Eigen::Index at = 0;
    for (const BlockModel& block : model.blocks) {
        Matrix6 mass = block.massMatrix;
        Vector6 own = force.segment<6>(at);
        for (int k = 0; k < 6; ++k) {
            if (!known(at + k) && block.mass > 0.0) continue;
            mass.row(k).setZero();
            mass.col(k).setZero();
            mass(k, k) = 1.0;
            own[k] = 0.0;
        }
        result.segment<6>(at) = mass.ldlt().solve(own);
        at += 6;
    }
    for (const BoltModel& bolt : model.bolts)
        for (std::size_t n = 0; n < bolt.s.size(); ++n) {
            const Eigen::Vector3d mass = nodeMass(bolt, n);
            for (int k = 0; k < 3; ++k, ++at)
                if (!known(at) && mass[k] > 0.0) result[at] = force[at] / mass[k];
        }
    return result;
}

Eigen::VectorXd timesMass(const Model& model, const Eigen::VectorXd& x) {
    Eigen::VectorXd product(x.size());
    Eigen::Index at = 0;
    for (const BlockModel& block : model.blocks) {
        product.segment<6>(at) = block.massMatrix * x.segment<6>(at);
        at += 6;
    }
    for (const BoltModel& bolt : model.bolts)
        for (std::size_t n = 0; n < bolt.s.size(); ++n) {
            product.segment<3>(at) = nodeMass(bolt, n).cwiseProduct(x.segment<3>(at));
            at += 3;
        }
    return product;
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

}  // namespace keyblock
