// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy balance of one dynamic step, as a measure of its accuracy. Within a step,
// displacements at contacts are linear, whereas blocks actually turn on arcs. Work is
// calculated along the straight path, but friction losses and spring energies are those
// at the end of the arc. The difference is the error of the energy balance (theory,
// "Energies").
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

struct StepEnergy {
    double left = 0.0;  // error of the energy balance [J]
    double lost = 0.0;  // dissipated by friction, plastic flow, damping and the scheme, or released [J]
    double scale = 0.0;  // largest energy term of the run [J]

    /// True if the error `left` exceeds `share` times the dissipated energy `lost`, and both exceed a small fraction of
    /// `scale`.
    bool leavesMoreThan(double share) const;
};

/// Energy balance of a step. All values are zero if no contact carries compression at the start or at the end, because
/// the step then contains no impact.
/// \param before the state at the start of the step, before its contacts were found.
/// \param after the accepted state at the end of the step.
StepEnergy energyOfStep(const Model& model, const State& before, const State& after);

}  // namespace keyblock
