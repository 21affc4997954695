// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Point supports: springs that fix points of blocks in x, y or both. A viscous boundary
// releases the supports on its sides and keeps their forces as loads.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Adds the supports of the scene to the model: point supports and fixed blocks.
/// \pre the model already contains its blocks.
void addSupports(const Scene& scene, Model& model);

/// Adds the links of the point supports to `problem`.
/// \param move the expected displacement of the blocks over the step, which determines the lever arms.
void addSupportLinks(const Model& model, const State& state, const StepMove& move, StepProblem& problem);

/// Strain of the link of a point support at the current position of the supported block [m].
double supportStrain(const Model& model, const BlockMotion& block, const Link& link);

/// Initial position of a point support [m].
Point startOf(const Model& model, const PointSupport& support);

/// Releases a point support, which then carries no force.
/// \param support the index in `Model::supports`.
/// \return the force that the support exerted on its block, to be kept as a load.
WallForce releaseSupport(const Model& model, State& state, std::size_t support);

/// Reactivates the released supports at their current positions, with the forces that they carried at release.
void restoreSupports(const Model& model, State& state);

/// The point supports as a force carrier (see `Carrier`).
extern const Carrier supportCarrier;

}  // namespace keyblock
