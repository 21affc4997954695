// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/sleep/sleepers.h"

#include "solver/engine/sleep/scene_part.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/time/mass.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr int quietSteps = 20;  // number after which a block falls asleep
constexpr double countedStep = 0.5;  // over the time step of the stage: shorter steps do not count
constexpr int fewestRings = 2;  // of blocks around a disturbed block that wake with it

/// Largest speed of a block's corners over a step, from above [m/s].
double blockSpeed(const BlockModel& block, const Vector6& d, double dt) {
    const double turned = std::abs(d[2]) + d.tail<3>().cwiseAbs().maxCoeff();
    return (d.head<2>().norm() + turned * block.size) / dt;
}

double boltSpeed(const Model& model, const BoltModel& bolt, const Eigen::VectorXd& d, double dt) {
    double largest = 0.0;
    const Eigen::Index first = 6 * static_cast<Eigen::Index>(model.blocks.size()) + 3 * bolt.firstNode;
    for (std::size_t n = 0; n < bolt.s.size(); ++n)
        largest = std::max(largest, d.segment<2>(first + 3 * static_cast<Eigen::Index>(n)).norm());
    return largest / dt;
}

/// Mass by which the force on a body is judged [kg]; for a face plate, that of the block against which it lies.
double judgedMass(const Model& model, std::size_t block) {
    const BlockModel& own = model.blocks[block];
    if (own.plateOf < 0 || own.rock < 0) return own.mass;
    return std::max(own.mass, model.blocks[model.firstOf[own.rock]].mass);
}

/// Most that may be left unbalanced on a sleeping block [N]. \param stepError what steps may leave there [N].
double mostLeft(const Model& model, std::size_t block, const SleepLimits& limits, double stepError) {
    return std::max(limits.tolerance * limits.weight * judgedMass(model, block), stepError);
}

/// The larger of a force and of a moment over the size of the block [N].
double sizeOf(const BlockModel& block, const Eigen::Vector3d& force) {
    return std::max(force.head<2>().norm(), std::abs(force[2]) / block.size);
}

/// What steps may leave unbalanced on each block at the tolerance of the scene [N].
std::vector<double> stepErrors(const Model& model, const StepProblem& problem) {
    std::vector<double> errors(model.blocks.size(), 0.0);
    for (const Link& link : problem.links) {
        const double force = link.law.share * std::abs(respond(link.law, link.strain).force);
        for (const auto& [body, gradient] : {std::pair(link.a, &link.ga), std::pair(link.b, &link.gb)})
            if (body >= 0 && body < problem.blocks)
                errors[body] += model.numerics.tolerance * force * gradient->head<2>().norm();
    }
    return errors;
}

/// Number of rings of blocks around a disturbed block that wake with it. In a plane the stress under a force falls with
/// the distance r, and the force that it leaves on a block with r².
int ringsAround(double disturbance) {
    return std::max(fewestRings, static_cast<int>(std::ceil(std::sqrt(std::min(disturbance, 1e6)))));
}

/// Spreads the number of rings still to wake from each block to those that touch it.
void spread(const Model& model, const State& state, std::vector<int>& rings) {
    for (bool more = true; more;) {
        more = false;
        const auto pass = [&](int from, int to) {
            if (rings[from] - 1 <= rings[to] || model.blocks[to].fixed) return;
            const int first = wholeOf(model, to);
            for (int cell = first; cell < endOfWhole(model, first); ++cell) rings[cell] = rings[from] - 1;
            more = true;
        };
        for (const Contact& c : state.contacts) {
            pass(c.blockA, c.blockB);
            pass(c.blockB, c.blockA);
        }
    }
}

/// Adds the force of a link on the sleeping blocks that it connects.
void addForce(const Model& part, const Link& link, double force, BlockForces& forces) {
    for (const auto& [body, gradient] : {std::pair(link.a, &link.ga), std::pair(link.b, &link.gb)})
        if (body >= 0 && body < static_cast<int>(part.blocks.size()) && part.blocks[body].asleep)
            forces[body] -= link.law.share * force * gradient->head<3>();
}

/// Keeps a mark only where all cells of a block have it.
void keepWhole(const Model& model, std::vector<char>& marks) {
    for (int i = 0; i < static_cast<int>(marks.size()); i = endOfWhole(model, i)) {
        const auto first = marks.begin() + i, end = marks.begin() + endOfWhole(model, i);
        if (!std::all_of(first, end, [](char mark) { return mark; })) std::fill(first, end, 0);
    }
}

BlockForces noForces(const Model& model) { return BlockForces(model.blocks.size(), Eigen::Vector3d::Zero()); }

}  // namespace

bool isSameForce(const LoadPoint& a, const LoadPoint& b) {
    return a.gravity == b.gravity && a.acceleration == b.acceleration && a.forces == b.forces &&
           a.pressures == b.pressures && a.walls == b.walls;
}

bool anyAsleep(const State& state) {
    return std::any_of(state.blocks.begin(), state.blocks.end(),
                       [](const BlockMotion& block) { return block.rest.asleep; });
}

bool isAllAsleep(const Model& model, const State& state) {
    if (!anyAsleep(state)) return false;
    for (std::size_t i = 0; i < state.blocks.size(); ++i)
        if (isAwake(model, state, i)) return false;
    const std::vector<char> bolts = awakeBolts(model, state);
    return std::none_of(bolts.begin(), bolts.end(), [](char awake) { return awake; });
}

void countQuietSteps(const Model& model, const Eigen::VectorXd& d, double dt, const SleepLimits& limits, State& state) {
    const double most = limits.tolerance * limits.weight * limits.timeStep;
    const bool counts = dt >= countedStep * limits.timeStep;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        if (!isAwake(model, state, i)) continue;
        const double speed = blockSpeed(model.blocks[i], d.segment<6>(6 * static_cast<Eigen::Index>(i)), dt);
        int& quiet = state.blocks[i].rest.quietSteps;
        quiet = speed <= most ? quiet + counts : 0;
    }
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        if (!acts(state.bolts[b]) || boltSpeed(model, model.bolts[b], d, dt) <= most) continue;
        for (int block : blocksOf(model.bolts[b], state.bolts[b])) state.blocks[block].rest.quietSteps = 0;
    }
}

std::vector<char> mayFallAsleep(const Model& model, const Loads& loads, const State& state) {
    std::vector<char> may(model.blocks.size(), 0);
    for (std::size_t i = 0; i < may.size(); ++i)
        may[i] = isAwake(model, state, i) && state.blocks[i].rest.quietSteps >= quietSteps;
    for (const PrescribedMotion& motion : loads.motions) may[motion.block] = 0;
    keepWhole(model, may);
    return may;
}

bool fallAsleep(const Model& model, const Loads& loads, const LoadPoint& at, const SleepLimits& limits,
                std::vector<char> may, State& state) {
    StepProblem problem = buildStep(model, state, loads, at, {Inertia::None});
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
    correctFrictionLimits(problem, still);
    const Eigen::VectorXd net = netForce(problem, still);
    const std::vector<double> errors = stepErrors(model, problem);
    for (std::size_t i = 0; i < may.size(); ++i) {
        const Eigen::Vector3d left = net.segment<3>(6 * static_cast<Eigen::Index>(i));
        may[i] = may[i] && sizeOf(model.blocks[i], left) <= mostLeft(model, i, limits, errors[i]);
    }
    keepWhole(model, may);
    if (std::none_of(may.begin(), may.end(), [](char one) { return one; })) return false;
    const double before = kineticEnergy(model, state);
    for (std::size_t i = 0; i < may.size(); ++i) {
        if (!may[i]) continue;
        state.blocks[i].rest = {true, 0, errors[i], Eigen::Vector3d::Zero()};
        state.blocks[i].velocity.setZero();
    }
    const std::vector<char> bolts = awakeBolts(model, state);
    for (std::size_t b = 0; b < bolts.size(); ++b)
        for (BoltNode& node : state.bolts[b].nodes)
            if (acts(state.bolts[b]) && !bolts[b]) node.velocity.setZero();
    state.energy.damped += before - kineticEnergy(model, state);
    return true;
}

BlockForces linkForces(const Model& part, const StepProblem& problem) {
    BlockForces forces = noForces(part);
    for (const Link& link : problem.links) addForce(part, link, carriedForce(link.law, link.strain), forces);
    return forces;
}

BlockForces linkForces(const Model& part, const StepProblem& problem, const Eigen::VectorXd& d) {
    BlockForces forces = noForces(part);
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    for (std::size_t i = 0; i < strains.size(); ++i)
        addForce(part, problem.links[i], respond(problem.links[i].law, strains[i]).force, forces);
    return forces;
}

BlockForces loadChanges(const Model& model, const State& state, const Loads& loads, const LoadPoint& before,
                        const LoadPoint& after) {
    if (isSameForce(before, after)) return {};
    double total = 0.0;
    const StepMove still{0.0};
    const Eigen::VectorXd change = externalForce(model, state, loads, after, still, total) -
                                   externalForce(model, state, loads, before, still, total);
    BlockForces changes = noForces(model);
    for (std::size_t i = 0; i < changes.size(); ++i)
        if (state.blocks[i].rest.asleep) changes[i] = change.segment<3>(6 * static_cast<Eigen::Index>(i));
    return changes;
}

bool wakeDisturbed(const Model& model, const SleepLimits& limits, const BlockForces& changes, State& state) {
    std::vector<int> rings(state.blocks.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const BlockRest& rest = state.blocks[i].rest;
        if (!rest.asleep) continue;
        const double disturbed = sizeOf(model.blocks[i], changes[i]) / mostLeft(model, i, limits, rest.stepError);
        if (disturbed <= 1.0) continue;
        any = true;
        const int first = wholeOf(model, static_cast<int>(i));
        for (int cell = first; cell < endOfWhole(model, first); ++cell)
            rings[cell] = std::max(rings[cell], 1 + ringsAround(disturbed));
    }
    if (!any) return false;
    spread(model, state, rings);
    for (std::size_t i = 0; i < rings.size(); ++i)
        if (rings[i] > 0 && state.blocks[i].rest.asleep) state.blocks[i].rest = {};
    return true;
}

void wakeAll(State& state) {
    for (BlockMotion& block : state.blocks) block.rest = {};
}

BlockForces changesOf(const State& state) {
    BlockForces changes;
    changes.reserve(state.blocks.size());
    for (const BlockMotion& block : state.blocks) changes.push_back(block.rest.change);
    return changes;
}

void setChanges(const BlockForces& changes, State& state) {
    for (std::size_t i = 0; i < changes.size(); ++i)
        if (state.blocks[i].rest.asleep) state.blocks[i].rest.change = changes[i];
}

}  // namespace keyblock
