// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/model/loads.h"

#include "solver/engine/model/edge.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

std::vector<double> mix(const std::vector<double>& a, const std::vector<double>& b, double share) {
    std::vector<double> mixed(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) mixed[i] = share >= 1.0 ? b[i] : a[i] + share * (b[i] - a[i]);
    return mixed;
}

class ForceSum {
public:
    explicit ForceSum(const Model& model)
        : blocks_(static_cast<Eigen::Index>(model.blocks.size())),
          forces(Eigen::VectorXd::Zero(6 * blocks_ + 3 * model.nodes)) {}

    void onBlock(int block, const Vector6& onUnknowns, const Point& force) {
        forces.segment<6>(6 * static_cast<Eigen::Index>(block)) += onUnknowns;
        total += force.norm();
    }

    void onNode(int node, const Point& force) {
        forces.segment<2>(6 * blocks_ + 3 * node) += force;
        total += force.norm();
    }

private:
    Eigen::Index blocks_;

public:
    Eigen::VectorXd forces;
    double total = 0.0;
};

void addGravity(const Model& model, const State& state, const Point& gravity, ForceSum& sum) {
    if (gravity.isZero(0.0)) return;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const BlockMotion& motion = state.blocks[i];
        const Point weight = model.blocks[i].mass * gravity;
        if (!motion.absent)
            sum.onBlock(static_cast<int>(i), displacementMatrix(motion, motion.centroid).transpose() * weight, weight);
    }
    Eigen::Index first = 6 * static_cast<Eigen::Index>(model.blocks.size());
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        const BoltModel& bolt = model.bolts[b];
        for (std::size_t e = 0; e < bolt.elements.size() && !state.bolts[b].absent; ++e) {
            const double mass = bolt.share * lumpedMass(bolt.section, bolt.elements[e].length);
            for (std::size_t node : {e, e + 1})
                sum.forces.segment<2>(first + 3 * static_cast<Eigen::Index>(node)) += mass * gravity;
            sum.total += 2.0 * mass * gravity.norm();
        }
        first += 3 * static_cast<Eigen::Index>(bolt.s.size());
    }
}

/// \param motion position of the block at which the force acts.
SingleLoad onBlock(ForceSource source, int block, const BlockMotion& motion, const Point& place, const Point& force) {
    return {source, block, -1, place - motion.centroid, force, displacementMatrix(motion, place).transpose() * force};
}

}  // namespace

LoadPoint between(const LoadPoint& a, const LoadPoint& b, double share) {
    LoadPoint point;
    point.time = share >= 1.0 ? b.time : a.time + share * (b.time - a.time);
    point.gravity = share >= 1.0 ? b.gravity : a.gravity + share * (b.gravity - a.gravity);
    point.acceleration = b.acceleration;
    if (share < 1.0) point.acceleration = a.acceleration + share * (b.acceleration - a.acceleration);
    point.forces = mix(a.forces, b.forces, share);
    point.pressures = mix(a.pressures, b.pressures, share);
    point.motions = mix(a.motions, b.motions, share);
    point.walls = mix(a.walls, b.walls, share);
    point.openings = mix(a.openings, b.openings, share);
    return point;
}

double longestDrive(const LoadPoint& a, const LoadPoint& b) {
    double longest = 0.0;
    const auto add = [&](const std::vector<double>& from, const std::vector<double>& to) {
        for (std::size_t i = 0; i < std::max(from.size(), to.size()); ++i)
            longest = std::max(longest, std::abs((i < to.size() ? to[i] : 0.0) - (i < from.size() ? from[i] : 0.0)));
    };
    add(a.motions, b.motions);
    add(a.openings, b.openings);
    return longest;
}

bool isSameLoad(const LoadPoint& a, const LoadPoint& b) {
    return a.gravity == b.gravity && a.acceleration == b.acceleration && a.forces == b.forces &&
           a.pressures == b.pressures && a.walls == b.walls && longestDrive(a, b) == 0.0;
}

std::vector<SingleLoad> singleLoads(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                                    const StepMove& move) {
    std::vector<SingleLoad> singles;
    singles.reserve(loads.forces.size() + loads.pressures.size() + loads.walls.size());
    for (std::size_t i = 0; i < loads.forces.size(); ++i) {
        const PointForce& f = loads.forces[i];
        const BlockMotion motion = onTheWay(model, state, f.block, move);
        singles.push_back(
            onBlock(ForceSource::Load, f.block, motion, materialPoint(motion, f.place), at.forces[i] * f.force));
    }
    for (std::size_t i = 0; i < loads.pressures.size(); ++i) {
        const EdgePressure& p = loads.pressures[i];
        const BlockMotion motion = onTheWay(model, state, p.block, move);
        const Edge edge = edgeOf(motion.corners, p.edge);
        const double length = (p.to - p.from) * edge.length;
        const Point middle = edge.start + 0.5 * (p.from + p.to) * edge.length * edge.along;
        singles.push_back(onBlock(ForceSource::Load, p.block, motion, middle,
                                  -at.pressures[i] * p.pressure * length * model.thickness * edge.outward));
    }
    for (std::size_t i = 0; i < loads.walls.size(); ++i) {
        const WallForce& w = loads.walls[i];
        const ForceSource source = w.ofSupport ? ForceSource::Support : ForceSource::Wall;
        const Point force = at.walls[i] * w.force;
        if (w.block >= 0) {
            const BlockMotion motion = onTheWay(model, state, w.block, move);
            singles.push_back(onBlock(source, w.block, motion, materialPoint(motion, w.place), force));
        } else {
            SingleLoad& single = singles.emplace_back();
            single.source = source;
            single.node = model.bolts[w.bolt].firstNode + w.node;
            single.force = force;
        }
    }
    return singles;
}

Point accelerationOf(const Model& model, const LoadPoint& at) { return at.gravity * model.gravity + at.acceleration; }

double weightPerMass(const Model& model, const LoadPoint& at) {
    return std::max({model.gravity.norm(), at.acceleration.norm(), (model.gravity + at.acceleration).norm()});
}

Eigen::VectorXd externalForce(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                              const StepMove& move, double& total) {
    ForceSum sum(model);
    addGravity(model, state, accelerationOf(model, at), sum);
    for (const SingleLoad& load : singleLoads(model, state, loads, at, move)) {
        if (load.block >= 0) sum.onBlock(load.block, load.onUnknowns, load.force);
        else sum.onNode(load.node, load.force);
    }
    total = sum.total;
    return sum.forces;
}

}  // namespace keyblock
