// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/model/step_move.h"

#include <Eigen/Geometry>
#include <cmath>

namespace keyblock {
namespace {

BlockMotion movedBy(const BlockModel& block, const BlockMotion& motion, const Vector6& way) {
    BlockMotion moved = motion;
    moveBlock(block, moved, way);
    return moved;
}

/// Chord over arc for a rotation by `turn` [rad].
double chordShare(double turn) { return turn == 0.0 ? 1.0 : std::sin(0.5 * turn) / (0.5 * turn); }

}  // namespace

Vector6 expectedMove(const Model& model, const State& state, int block, const StepMove& move) {
    if (model.blocks[block].fixed) return Vector6::Zero();
    if (move.path) return move.path->segment<6>(6 * static_cast<Eigen::Index>(block));
    Vector6 way = move.dt * state.blocks[block].velocity;
    way.tail<3>().setZero();
    return way;
}

BlockMotion onTheWay(const Model& model, const State& state, int block, const StepMove& move) {
    const Vector6 way = move.share * expectedMove(model, state, block, move);
    return way.isZero(0.0) ? state.blocks[block] : movedBy(model.blocks[block], state.blocks[block], way);
}

PointMove pointMove(const Model& model, const State& state, int block, const Point& place, const StepMove& move) {
    const BlockMotion& start = state.blocks[block];
    const Vector6 way = expectedMove(model, state, block, move);
    if (way.isZero(0.0)) return {displacementMatrix(start, materialPoint(start, place)), {0.0, 0.0}};
    const BlockMotion middle = movedBy(model.blocks[block], start, 0.5 * way);
    PointMove point{displacementMatrix(middle, materialPoint(middle, place)), {0.0, 0.0}};
    // R₁F₁ − R₀F₀ = (R₁ − R₀)·½(F₀ + F₁) + ½(R₀ + R₁)·(F₁ − F₀) for F = 1 + ε
    point.t.col(2) *= chordShare(way[2]);
    point.t.rightCols<3>() *= std::cos(0.5 * way[2]);
    if (move.share == 0.5) return point;
    const Point all = point.t * way;
    const Eigen::Rotation2Dd later((move.share - 0.5) * way[2]);
    point.t.rightCols<4>() = later.toRotationMatrix() * point.t.rightCols<4>();
    point.beyond = all - point.t * way;
    return point;
}

}  // namespace keyblock
