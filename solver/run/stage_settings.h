// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a stage is solved, from what the scene says of it and what is usual where it
// says nothing.
#pragma once

#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/statics.h"
#include "solver/run/stage_loads.h"

#include <vector>

namespace keyblock {

/// Increments of a static stage in which something changes, where it gives no number.
inline constexpr int usualIncrements = 100;

StaticSettings staticSettings(const Scene& scene, const Stage& stage);
DynamicSettings dynamicSettings(const Scene& scene, const Stage& stage);

/// Pseudo-times at which the increments of a static stage end: 0 for what it puts on at once, then the increments, with
/// every turn of a table among them. \param loads begun for that stage.
std::vector<double> incrementTimes(const Stage& stage, const StageLoads& loads);

/// Viscous sides of a stage. \pre the scene was checked without errors.
std::vector<BoundarySide> viscousSides(const Stage& stage);

/// Gives a block, all cells of it, the velocity of one body.
void setVelocity(const Scene& scene, const Model& model, const InitialVelocity& initial, State& state);

}  // namespace keyblock
