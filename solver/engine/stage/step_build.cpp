// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Adds inertia, block elasticity, loads and prescribed displacements to a step; the
// carriers add the links.
#include "solver/engine/stage/step_build.h"

#include "solver/engine/bolt/bolt.h"
#include "solver/engine/stage/carriers.h"
#include "solver/engine/step/phase.h"
#include "solver/engine/time/mass.h"

#include <algorithm>

namespace keyblock {
namespace {

constexpr double smallestStrain = 1e-12;  // forces that cause smaller strains count as zero

/// Force at which the strain of a block is lost in round-off [N].
double floorOf(const BlockModel& block, const Model& model) {
    return smallestStrain * block.youngsModulus * block.size * model.thickness;
}

/// Magnitude of the loads on each body plus a small minimum [N].
std::vector<double> ownForces(const Model& model, const StepProblem& problem, const Eigen::VectorXd& external) {
    const Eigen::VectorXd forces = external.cwiseProduct(problem.weight);
    std::vector<double> own;
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        own.push_back(forces.segment<6>(6 * static_cast<Eigen::Index>(i)).norm() + floorOf(model.blocks[i], model));
    for (const BoltModel& bolt : model.bolts) {
        const double least = smallestStrain * bolt.share * bolt.section.youngsModulus * bolt.section.area;
        for (std::size_t n = 0; n < bolt.s.size(); ++n)
            own.push_back(forces.segment<3>(problem.first(static_cast<int>(own.size()))).norm() + least);
    }
    return own;
}

void addBlocks(const Model& model, const State& state, const SchemeFactors& factors, StepProblem& problem) {
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const BlockModel& block = model.blocks[i];
        const BlockMotion& motion = state.blocks[i];
        const double volume = block.area * model.thickness;
        const auto at = 6 * static_cast<Eigen::Index>(i);
        Matrix6 stiffness = factors.inertia.d * block.massMatrix;
        stiffness.bottomRightCorner<3, 3>() += factors.elastic * volume * block.elasticity;
        problem.blockStiffness.push_back(stiffness);
        problem.places.push_back(motion.centroid);
        if (block.fixed || block.asleep || motion.absent)
            for (Eigen::Index k = at; k < at + 6; ++k) problem.known[k] = 1;
        if (motion.absent) continue;
        const Vector6 momentum = -factors.inertia.v * block.massMatrix * motion.velocity;
        problem.load.segment<6>(at) += momentum;
        problem.load.segment<3>(at + 3) -= volume * frameStress(block, motion);
        problem.weight.segment<4>(at + 2).setConstant(1.0 / block.size);
        problem.floorForce = std::max(problem.floorForce, floorOf(block, model));
    }
}

void addNodes(const Model& model, const State& state, const SchemeFactors& factors, StepProblem& problem) {
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        const BoltModel& bolt = model.bolts[b];
        const BoltMotion& motion = state.bolts[b];
        for (std::size_t n = 0; n < bolt.s.size(); ++n) {
            const Eigen::Vector3d mass = nodeMass(bolt, n);
            const Eigen::Index at = problem.first(problem.blocks + bolt.firstNode + static_cast<int>(n));
            problem.nodeStiffness.push_back(factors.inertia.d * mass);
            problem.places.push_back(motion.nodes[n].x);
            const Eigen::Vector3d momentum = -factors.inertia.v * mass.cwiseProduct(motion.nodes[n].velocity);
            problem.load.segment<3>(at) += momentum;
            problem.weight[at + 2] = 1.0 / bolt.elements[std::min(n, bolt.elements.size() - 1)].length;
            if (!bolt.bends || !acts(motion)) problem.known[at + 2] = 1;
            if (!acts(motion)) problem.known[at] = problem.known[at + 1] = 1;
        }
    }
}

void prescribe(const Model& model, const State& state, const Loads& loads, const LoadPoint& at, StepProblem& problem) {
    for (std::size_t i = 0; i < loads.motions.size(); ++i) {
        const PrescribedMotion& motion = loads.motions[i];
        const Eigen::Index first = 6 * static_cast<Eigen::Index>(motion.block);
        problem.known[first] = 1;
        problem.value[first] = at.motions[i] - displacementAlong(model, state, motion);
        if (motion.holdsRotation) problem.known[first + 2] = 1;
    }
}

}  // namespace

double displacementAlong(const Model& model, const State& state, const PrescribedMotion& motion) {
    return motion.axis.dot(state.blocks[motion.block].centroid - model.blocks[motion.block].centroid);
}

StepProblem buildStep(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                      const StepOptions& options) {
    const PhaseScope phase(Phase::Build);
    StepProblem problem;
    problem.blocks = static_cast<int>(model.blocks.size());
    problem.nodes = model.nodes;
    const int n = problem.unknowns();
    const Eigen::VectorXd external = externalForce(model, state, loads, at, moveOf(options), problem.externalForce);
    problem.load = external;
    problem.known.assign(n, 0);
    problem.value = Eigen::VectorXd::Zero(n);
    problem.weight = Eigen::VectorXd::Ones(n);
    const SchemeFactors factors = factorsOf(options);
    problem.rule = factors.rule;
    problem.contactShare = factors.contactShare;
    addBlocks(model, state, factors, problem);
    addNodes(model, state, factors, problem);
    if (factors.inertia.a != 0.0) problem.load -= factors.inertia.a * timesMass(model, accelerationsOf(model, state));
    prescribe(model, state, loads, at, problem);
    problem.links.reserve(2 * (state.contacts.size() + model.supports.size()) + 3 * model.glue.size() +
                          linksANode * static_cast<std::size_t>(model.nodes));
    problem.openings = at.openings;
    problem.moves = options.inertia != Inertia::Static && options.inertia != Inertia::None;
    problem.ownForce = ownForces(model, problem, external);
    for (const Carrier* carrier : carriers) carrier->addLinks({model, state, loads, options}, problem);
    return problem;
}

}  // namespace keyblock
