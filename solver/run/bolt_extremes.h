// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Largest forces in the bolts and highest utilisation of their strengths over a run.
// They are updated at every step, because a force between two frames may be larger
// than in either frame.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// Initial extremes, indexed by bolt, with zero forces. The utilisation of a strength that a bolt does not have is −1.
std::vector<BoltExtremes> startExtremes(const Model& model);

/// Updates the extremes with the forces of the bolts in `state`.
void addExtremes(const Model& model, const State& state, int stage, double time, std::vector<BoltExtremes>& extremes);

/// Utilisation u of the steel under an axial force N and a moment M. N_p and M_p are the values at which the
/// cross-section becomes fully plastic under N or M alone; under N/u and M/u together, the cross-section is just fully
/// plastic: (N/(u·N_p))² + |M|/(u·M_p) = 1.
/// \param axial the ratio N/N_p.
/// \param bending the ratio M/M_p.
double steelUse(double axial, double bending);

}  // namespace keyblock
