// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy balance of one dynamic step, as a measure of its accuracy. Contacts
// are straight in a step and blocks turn on arcs: work is done along one, and what
// friction used and springs hold is found at the end of the other. What the balance
// leaves over is the difference (theory, "Energies").
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

struct StepEnergy {
    double left = 0.0;  // what the balance leaves over [J]
    double lost = 0.0;  // by friction, plastic flow, damping, the scheme and what was released [J]
    double scale = 0.0;  // largest energy of the run so far [J]

    /// True where more is left over than `share` of what was lost, both in amounts that count in the scene.
    bool leavesMoreThan(double share) const;
};

/// Nothing where no contact pushes: there is no impact.
/// \param before as the step began, before its contacts were sought. \param after as it was accepted.
StepEnergy energyOfStep(const Model& model, const State& before, const State& after);

}  // namespace keyblock
