// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point supports: springs that fix points of blocks in x, y or both. A viscous
// boundary releases those on its sides and keeps their force.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Adds the supports of the scene to the model: point supports, and blocks that are fixed as a whole.
/// \pre the model has its blocks
void addSupports(const Scene& scene, Model& model);

/// Links of the point supports. \param move of the blocks over the step, within which supports take their lever arms.
void addSupportLinks(const Model& model, const State& state, const StepMove& move, StepProblem& problem);

/// Strain of a support's link where its block is [m].
double supportStrain(const Model& model, const BlockMotion& block, const Link& link);

/// Position of a point support at the start [m].
Point startOf(const Model& model, const PointSupport& support);

/// The support carries nothing from now on. \return the force that it gave to its block, to be kept as a load
WallForce releaseSupport(const Model& model, State& state, std::size_t support);

/// Released supports carry force again, where they are and the force that they gave.
void restoreSupports(const Model& model, State& state);

/// Links and energy of the point supports.
extern const Carrier supportCarrier;

}  // namespace keyblock
