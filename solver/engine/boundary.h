// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides of the model that let waves out: dashpots of the rock's own impedance in
// place of what held the side, whose forces stay (theory, "Viscous boundaries").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

#include <vector>

namespace keyblock {

/// Two dashpots a face on the sides of the domain, or of the box round all blocks where there is none: density · wave
/// speed · area, of pressure waves across the side and of shear waves along it.
std::vector<Dashpot> dashpotsOn(const Model& model, const State& state, const std::vector<BoundarySide>& sides);

/// Held points on the sides let go. \return the forces that they gave, to be kept.
std::vector<WallForce> letGo(const Model& model, State& state, const std::vector<BoundarySide>& sides);

/// Points that were let go hold again, where they are and with the force that they gave.
void holdAgain(const Model& model, State& state);

/// Links of the dashpots over a step in motion.
void addDashpots(const Model& model, const State& state, const Loads& loads, const StepOptions& options,
                 StepProblem& problem);

}  // namespace keyblock
