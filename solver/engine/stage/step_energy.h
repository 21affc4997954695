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

    /// True if the error exceeds `share` times the loss and both are significant relative to `scale`.
    bool leavesMoreThan(double share) const;
};

/// Energy balance of a step; all zero if no contact carries compression, because there is then no impact.
/// \param before the state at the start of the step, before its contacts were found.
/// \param after the accepted state.
StepEnergy energyOfStep(const Model& model, const State& before, const State& after);

}  // namespace keyblock
