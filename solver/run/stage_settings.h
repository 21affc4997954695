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

/// Pseudo-times at which the increments of a static stage end: 0 for loads applied at once, then the ends of the
/// increments, including every entry of a load table. If the stage gives no number of increments, their lengths are
/// chosen during the run, but increments always end at these times: at entries of load tables and where `output`
/// requests a frame. \param loads loads for which this stage has begun.
std::vector<double> incrementTimes(const Scene& scene, const Stage& stage, const StageLoads& loads);

/// Time between the frames of a stage, in the time of the stage; null if `output` does not set it.
std::optional<double> framesEvery(const Scene& scene, const Stage& stage);

/// Time between the frames of a stage, in the time of the stage; the default if `output` does not set it.
double frameInterval(const Scene& scene, const Stage& stage);

/// Largest number of frames at equal intervals from the start of the run to the end of a stage.
long plannedFrames(const Scene& scene, int stage);

/// Sides of the domain that are viscous boundaries in a stage. \pre the scene was checked without errors.
std::vector<BoundarySide> viscousSides(const Stage& stage);

/// Sets the initial velocity of a block; all its cells move as one rigid body.
void setVelocity(const Scene& scene, const Model& model, const InitialVelocity& initial, State& state);

}  // namespace keyblock
