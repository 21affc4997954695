// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where forces on points of blocks act within a step in motion. A step is solved
// with displacements linear in the rotation, and then blocks turn exactly: forces
// with the lever arms of its start would do work on the difference, and a pendulum
// would gain energy (theory, "Point supports").
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// What is known of the displacements over a step before it is solved, and when in it forces act.
struct StepMove {
    double dt = 0.0;  // [s]; 0: forces act where the bodies are at its start
    double share = 0.5;  // of the step, at which forces act
    const Eigen::VectorXd* path = nullptr;  // displacement of every unknown over the step, where it is known
};

/// Displacement of a block over the step: that of the path; else at the speed that it has, as a rigid body, because
/// strain rates may ring from step to step and predict nothing. Zero for a fixed block.
Vector6 expectedMove(const Model& model, const State& state, int block, const StepMove& move);

/// The block at the moment of the step at which forces act.
BlockMotion onTheWay(const Model& model, const State& state, int block, const StepMove& move);

/// Displacement of a material point over a step: t·d + beyond.
struct PointMove {
    Eigen::Matrix<double, 2, 6> t;  // by the block's unknowns; its transpose takes a force to them
    Point beyond{0.0, 0.0};  // [m]; 0 where forces act in the middle of the step
};

/// Exact for the displacement that is expected, and T(x) where nothing moves. \param place from the centroid in the
/// block's frame at the start [m]
PointMove pointMove(const Model& model, const State& state, int block, const Point& place, const StepMove& move);

}  // namespace keyblock
