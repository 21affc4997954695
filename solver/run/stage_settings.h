// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a stage is solved, from what the scene says of it and what is usual where it
// says nothing.
#pragma once

#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/statics.h"
#include "solver/run/stage_loads.h"

#include <optional>
#include <vector>

namespace keyblock {

StaticSettings staticSettings(const Scene& scene, const Stage& stage);
DynamicSettings dynamicSettings(const Scene& scene, const Stage& stage);

/// Pseudo-times at which the increments of a static stage end: 0 for what it puts on at once, then the increments, with
/// every turn of a table among them. Where the stage gives no number, its increments are chosen while it runs and end at
/// these times at least: where a table turns, and where `output` requests a frame. \param loads begun for that stage.
std::vector<double> incrementTimes(const Scene& scene, const Stage& stage, const StageLoads& loads);

/// Time between the frames of a stage, of its own time; null: `output` leaves it to the program.
std::optional<double> framesEvery(const Scene& scene, const Stage& stage);

/// The same, or what the program takes where `output` leaves it to it.
double frameInterval(const Scene& scene, const Stage& stage);

/// Frames at equal intervals until the end of a stage, at most.
long plannedFrames(const Scene& scene, int stage);

/// Viscous sides of a stage. \pre the scene was checked without errors.
std::vector<BoundarySide> viscousSides(const Stage& stage);

/// Gives a block, all cells of it, the velocity of one body.
void setVelocity(const Scene& scene, const Model& model, const InitialVelocity& initial, State& state);

}  // namespace keyblock
