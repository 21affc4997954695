// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position at which forces on points of blocks act within a dynamic step. A step is
// solved with displacements linear in the rotation, after which the blocks are rotated
// exactly. With the lever arms of the start, forces would do work on the difference and
// a pendulum would gain energy (theory, "Point supports").
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Prediction of the displacements over a step before it is solved, and the time within the step at which forces act.
struct StepMove {
    double dt = 0.0;  // time step [s]; 0: forces act at the positions at the start of the step
    double share = 0.5;  // fraction of the step at which forces act
    const Eigen::VectorXd* path = nullptr;  // displacement of every unknown over the step; null: unknown
};

/// Expected displacement of a block over the step: its displacement along the path or, if there is no path, a
/// rigid-body displacement at the current velocity. Strain rates are not used, because they may oscillate from step to
/// step. Zero for a fixed block.
Vector6 expectedMove(const Model& model, const State& state, int block, const StepMove& move);

/// Expected position of the block at the time within the step at which forces act.
BlockMotion onTheWay(const Model& model, const State& state, int block, const StepMove& move);

/// Displacement of a material point over a step as a linear function of the displacement d of its block: t·d + beyond.
struct PointMove {
    Eigen::Matrix<double, 2, 6> t;  // matrix for the block's unknowns; its transpose gives the generalised force
    Point beyond{0.0, 0.0};  // constant part [m]; 0 if forces act in the middle of the step
};

/// Linear function for the displacement of a material point over a step (see `PointMove`). It is exact if the block's
/// displacement d is `expectedMove`. If `expectedMove` is zero, t is the `displacementMatrix` at the start of the step.
/// \param place the position relative to the centroid, in the block's initial frame [m].
PointMove pointMove(const Model& model, const State& state, int block, const Point& place, const StepMove& move);

}  // namespace keyblock
