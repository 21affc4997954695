// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/model/state.h"

#include <Eigen/LU>
#include <cmath>

namespace keyblock {
namespace {

Eigen::Matrix2d rotation(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return (Eigen::Matrix2d() << c, -s, s, c).finished();
}

/// I + ε, with the strain ε.
Eigen::Matrix2d stretch(const BlockMotion& m) {
    return (Eigen::Matrix2d() << 1.0 + m.strain[0], 0.5 * m.strain[2], 0.5 * m.strain[2], 1.0 + m.strain[1]).finished();
}

/// R(θ)·(I + ε): maps a vector from the centroid in the block's initial shape to the present shape.
Eigen::Matrix2d deformation(const BlockMotion& m) { return rotation(m.angle) * stretch(m); }

}  // namespace

bool isSameConfiguration(const State& a, const State& b) {
    return a.blocks == b.blocks && a.contacts == b.contacts && a.bolts == b.bolts && a.supports == b.supports &&
           a.glue == b.glue && a.openings == b.openings && a.acceleration == b.acceleration;
}

void stopMotion(State& state) {
    for (BlockMotion& block : state.blocks) block.velocity.setZero();
    for (BoltMotion& bolt : state.bolts)
        for (BoltNode& node : bolt.nodes) node.velocity.setZero();
}

void placeCorners(const BlockModel& block, BlockMotion& motion) {
    const Eigen::Matrix2d f = deformation(motion);
    motion.corners.resize(block.shape.size());
    for (std::size_t i = 0; i < block.shape.size(); ++i) motion.corners[i] = motion.centroid + f * block.shape[i];
}

Point materialPoint(const BlockMotion& motion, const Point& place) {
    return motion.centroid + deformation(motion) * place;
}

Point materialPlace(const BlockMotion& motion, const Point& x) {
    return deformation(motion).inverse() * (x - motion.centroid);
}

BlockFrame frameOf(const BlockMotion& motion) {
    const Eigen::Matrix2d r = rotation(motion.angle);
    return {motion.centroid, motion.axis, r, (r * stretch(motion)).inverse()};
}

Eigen::Matrix<double, 2, 6> displacementMatrix(const BlockFrame& frame, const Point& x) {
    const Point d = x - frame.centroid;
    const Point own = frame.toFirstShape * d;  // strains refer to the initial shape
    Eigen::Matrix<double, 2, 6> t;
    t.col(0) = frame.axis;
    t.col(1) = turnLeft(frame.axis);
    t.col(2) = turnLeft(d);
    t.col(3) = frame.rotation.col(0) * own.x();
    t.col(4) = frame.rotation.col(1) * own.y();
    t.col(5) = frame.rotation * Point(0.5 * own.y(), 0.5 * own.x());
    return t;
}

Eigen::Matrix<double, 2, 6> displacementMatrix(const BlockMotion& motion, const Point& x) {
    return displacementMatrix(frameOf(motion), x);
}

Eigen::Vector3d frameStress(const BlockModel& block, const BlockMotion& motion) {
    return motion.preStress + block.elasticity * motion.strain;
}

Point centroidVelocity(const BlockMotion& motion) {
    return motion.velocity[0] * motion.axis + motion.velocity[1] * turnLeft(motion.axis);
}

void turnUnknowns(BlockMotion& motion, const Point& axis) {
    const Point velocity = centroidVelocity(motion);
    motion.axis = axis.normalized();
    motion.velocity[0] = velocity.dot(motion.axis);
    motion.velocity[1] = velocity.dot(turnLeft(motion.axis));
}

void moveBlock(const BlockModel& block, BlockMotion& motion, const Vector6& d) {
    motion.centroid += d[0] * motion.axis + d[1] * turnLeft(motion.axis);
    motion.angle += d[2];
    motion.strain += d.tail<3>();
    placeCorners(block, motion);
}

BoltMotion boltAtRest(const BoltModel& bolt) {
    BoltMotion motion;
    motion.slots = bolt.slots;
    motion.leftSlot.assign(bolt.slots.size(), 0);
    motion.elements.resize(bolt.elements.size());
    motion.plateHolds = bolt.plate.present;
    motion.tensioning = bolt.plate.present && bolt.pretension > 0.0;
    for (double s : bolt.s) {
        BoltNode node;
        node.x = bolt.farEnd + s * bolt.axis;
        motion.nodes.push_back(node);
    }
    return motion;
}

State makeState(const Model& model) {
    State state;
    for (const BlockModel& block : model.blocks) {
        BlockMotion motion;
        motion.centroid = block.centroid;
        motion.preStress = Eigen::Vector3d(block.initialStress[0], block.initialStress[1], block.initialStress[2]);
        placeCorners(block, motion);
        state.blocks.push_back(std::move(motion));
    }
    state.glue.resize(model.glue.size());
    for (const BoltModel& bolt : model.bolts) state.bolts.push_back(boltAtRest(bolt));
    return state;
}

}  // namespace keyblock
