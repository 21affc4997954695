// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest forces in the bolts and the highest use of their strengths over a
// run. They are kept step by step, because a force between two frames may be
// larger than in either.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// A row per bolt, without any force yet; the use of a strength that the bolt does not have stays below zero.
std::vector<BoltExtremes> startExtremes(const Model& model);

/// Takes the forces of the bolts in `state` into account.
void addExtremes(const Model& model, const State& state, int stage, double time, std::vector<BoltExtremes>& extremes);

/// Use of the steel by an axial force and a moment that grow together: the share of the forces at which a
/// cross-section is plastic, (N/N_p)² + |M|/M_p = 1. 1 at either strength alone.
/// \param axial N/N_p. \param bending M/M_p.
double steelUse(double axial, double bending);

}  // namespace keyblock
