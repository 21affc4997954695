// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solver settings of a stage, from the scene or, where it gives none, from defaults.
#pragma once

#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/statics.h"
#include "solver/run/stage_loads.h"

#include <optional>
#include <vector>

namespace keyblock {

StaticSettings staticSettings(const Scene& scene, const Stage& stage);
DynamicSettings dynamicSettings(const Scene& scene, const Stage& stage);

/// Unbalanced force on a sleeping block over its weight; 0 if no block may sleep.
double sleepTolerance(const Scene& scene);

/// Pseudo-times at which the increments of a static stage end. The first is 0, for loads that are applied at once. It
/// is the only one if no load varies and the stage does not set the number of increments. If the stage sets the number
/// of increments, the list contains the ends of equal increments and the times of all entries of load and motion
/// tables. Otherwise, the lengths of the increments are chosen during the run, and the list contains only the times at
/// which an increment must end: the times of the table entries, the times at which `output` requests a frame, and 1.
/// \param loads the loads, for which `begin` has been called with this stage.
std::vector<double> incrementTimes(const Scene& scene, const Stage& stage, const StageLoads& loads);

/// Interval between the frames of a stage: [s], or pseudo-time in a static stage. It is null if `output` does not set
/// it.
std::optional<double> framesEvery(const Scene& scene, const Stage& stage);

/// Interval between the frames of a stage: [s], or pseudo-time in a static stage. If `output` does not set it, the
/// default is returned.
double frameInterval(const Scene& scene, const Stage& stage);

/// Largest number of frames at equal intervals from the start of the run to the end of a stage.
long plannedFrames(const Scene& scene, int stage);

/// Sides of the domain that are viscous boundaries in a stage. \pre `checkScene` found no error in the scene.
std::vector<BoundarySide> viscousSides(const Stage& stage);

/// Sets the initial velocity of a block; all its cells move as one rigid body.
void setVelocity(const Scene& scene, const Model& model, const InitialVelocity& initial, State& state);

}  // namespace keyblock
