// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/observation.h"

#include "solver/engine/bolt/bolt.h"
#include "solver/engine/contact/bonded_face.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/stage/energy.h"
#include "solver/run/block_extremes.h"
#include "solver/run/bolt_readings.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

std::array<double, 3> globalStress(const BlockModel& block, const BlockMotion& motion) {
    const Eigen::Vector3d own = frameStress(block, motion);
    Eigen::Matrix2d stress, turn;
    stress << own[0], own[2], own[2], own[1];
    turn << std::cos(motion.angle), -std::sin(motion.angle), std::sin(motion.angle), std::cos(motion.angle);
    const Eigen::Matrix2d global = turn * stress * turn.transpose();
    return {global(0, 0), global(1, 1), global(0, 1)};
}

ContactState contactState(const Contact& c) {
    if (c.bonded) return ContactState::Bonded;
    if (c.normalForce <= 0.0) return ContactState::Open;
    return std::abs(c.shearForce) >= c.limit * (1.0 - 1e-12) ? ContactState::Sliding : ContactState::Locked;
}

ContactFrame contactFrame(const Contact& c, const Model& model, const State& state) {
    ContactFrame f;
    f.blockA = c.blockA;
    f.blockB = c.blockB;
    f.jointMaterial = c.joint < builtInRow(model) ? c.joint : c.joint == intactRow(model) ? intactJoint : builtInJoint;
    f.position = c.position + model.origin;
    f.normal = edgeOf(state.blocks[c.blockB].corners, c.edge).outward;
    f.state = contactState(c);
    const ContactForces forces = forcesAtCorner(state.contacts, c);
    f.normalForce = forces.normal;
    f.shearForce = forces.shear;
    f.penetration = -c.gap;
    f.slip = c.slip;
    return f;
}

double areaOf(const std::vector<Point>& corners) {
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    return 0.5 * twice;
}

}  // namespace

bool isShown(const Contact& contact) { return contact.bonded || contact.normalForce > 0.0; }

Observation::Observation(const Scene& scene, const Model& model, const State& start, Reference& reference)
    : scene_(scene), model_(model), reference_(reference) {
    for (const Monitor& monitor : scene.monitors) {
        std::array<Fixed, 2> fixed;
        const auto fix = [&](std::size_t which, const Point& p) {
            const int block = blockWithPoint(scene, p);
            const Point own = p - model.origin;
            const int row = rowHolding(model, block, own);
            fixed[which] = {row, materialPlace(start.blocks[row], own)};
        };
        if (monitor.point) fix(0, *monitor.point);
        if (monitor.between) {
            fix(0, (*monitor.between)[0]);
            fix(1, (*monitor.between)[1]);
        }
        fixed_.push_back(fixed);
    }
    zero(start);
}

Point Observation::pointNow(const State& state, std::size_t monitor, std::size_t which) const {
    const Fixed& fixed = fixed_[monitor][which];
    if (fixed.block < 0) return {0.0, 0.0};
    return materialPoint(state.blocks[fixed.block], fixed.place);
}

Point Observation::moved(const State& state, std::size_t monitor, std::size_t which) const {
    return pointNow(state, monitor, which) - reference_.monitorPoints[2 * monitor + which];
}

void Observation::zero(const State& state) {
    reference_ = {};
    for (const BlockMotion& block : state.blocks) {
        reference_.centroids.push_back(block.centroid);
        reference_.angles.push_back(block.angle);
    }
    for (std::size_t m = 0; m < fixed_.size(); ++m)
        for (std::size_t which : {0, 1}) reference_.monitorPoints.push_back(pointNow(state, m, which));
}

/// The state of a block without its outline.
BlockState Observation::blockMoved(const State& state, int index) const {
    const std::size_t i = index;
    const BlockMotion& motion = state.blocks[i];
    BlockState block;
    block.centroid = motion.centroid + model_.origin;
    block.displacement = motion.centroid - reference_.centroids[i];
    block.rotation = motion.angle - reference_.angles[i];
    block.stress = globalStress(model_.blocks[i], motion);
    block.velocity = centroidVelocity(motion);
    return block;
}

BlockState Observation::blockState(const State& state, int index) const {
    const std::size_t i = index;
    const BlockMotion& motion = state.blocks[i];
    if (motion.absent) return {};
    BlockState block = blockMoved(state, index);
    block.area = areaOf(motion.corners);
    block.weight = model_.blocks[i].mass * model_.gravity.norm();
    for (const Point& corner : motion.corners) block.points.push_back(corner + model_.origin);
    return block;
}

Frame Observation::frame(const State& state, int stage, double time) const {
    Frame frame;
    frame.stage = stage;
    frame.time = time;
    frame.step = state.step;
    for (int i = 0; i < static_cast<int>(state.blocks.size()); ++i) frame.blocks.push_back(blockState(state, i));
    for (const Contact& c : state.contacts)
        if (isShown(c)) frame.contacts.push_back(contactFrame(c, model_, state));
    for (std::size_t b = 0; b < state.bolts.size(); ++b) {
        frame.bolts.push_back(boltFrame(model_.bolts[b], state.bolts[b], model_.origin));
        frame.bolts.back().elasticEnergy = boltEnergy(model_, state, static_cast<int>(b));
    }
    frame.energy = energyOf(model_, state);
    return frame;
}

void Observation::addExtremes(const State& state, int stage, double time, std::vector<BlockExtremes>& extremes) const {
    for (std::size_t b = 0; b < state.blocks.size(); ++b)
        if (!state.blocks[b].absent && !state.blocks[b].rest.asleep)
            addExtreme(blockMoved(state, static_cast<int>(b)), stage, time, extremes[b]);
}

void Observation::addMonitor(const State& state, std::size_t index, std::vector<double>& values) const {
    const Monitor& monitor = scene_.monitors[index];
    if (monitor.point) {
        const Point u = moved(state, index, 0);
        values.push_back(u.x());
        values.push_back(u.y());
    } else if (monitor.between) {
        values.push_back((moved(state, index, 1) - moved(state, index, 0)).dot(monitor.axis.normalized()));
    } else {
        const auto same = std::find_if(scene_.bolts.begin(), scene_.bolts.end(),
                                       [&](const Bolt& b) { return b.name == *monitor.bolt; });
        const std::size_t b = same - scene_.bolts.begin();
        const bool placed = monitor.at || monitor.atFromHead || monitor.atFraction;
        values.push_back(placed ? boltValueAt(model_.bolts[b], state.bolts[b], monitor.quantity,
                                              distanceAlong(monitor, model_.bolts[b].s.back()))
                                : boltExtreme(model_.bolts[b], state.bolts[b], monitor.quantity));
    }
}

HistoryRow Observation::history(const State& state, int stage, double time) const {
    HistoryRow row;
    row.stage = stage;
    row.time = time;
    row.step = state.step;
    for (std::size_t m = 0; m < scene_.monitors.size(); ++m) addMonitor(state, m, row.values);
    for (std::size_t b = 0; b < state.bolts.size(); ++b)
        for (const BoltQuantityRow& quantity : boltQuantityRows)
            row.values.push_back(boltExtreme(model_.bolts[b], state.bolts[b], quantity.quantity));
    return row;
}

}  // namespace keyblock
