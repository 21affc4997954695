// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides of the model that let waves out: dashpots of the rock's own impedance in
// place of what held the side, whose forces stay (theory, "Viscous boundaries").
#pragma once

#include "solver/engine/loads.h"
#include "solver/engine/step_problem.h"
#include "solver/engine/time_scheme.h"

#include <vector>

namespace keyblock {

/// Which sides of the box round all blocks.
struct Sides {
    bool left = false, right = false, bottom = false, top = false;

    bool any() const { return left || right || bottom || top; }
};

/// Two dashpots a face on the sides: density · wave speed · area, of pressure waves across the side and of shear waves
/// along it.
std::vector<Dashpot> dashpotsOn(const Model& model, const State& state, const Sides& sides);

/// Held points on the sides let go. \return the forces that they gave, to be kept.
std::vector<WallForce> letGo(const Model& model, State& state, const Sides& sides);

/// Points that were let go hold again, where they are and with the force that they gave.
void holdAgain(const Model& model, State& state);

/// Links of the dashpots over a step in motion.
void addDashpots(const Model& model, const State& state, const Loads& loads, const StepOptions& options,
                 StepProblem& problem);

}  // namespace keyblock
