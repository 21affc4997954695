// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The nut of a pre-tensioned bolt: while a jack pulls, the plate's force is the
// pretension whatever moves; once the rock has come to rest the nut locks off
// and the plate is a spring that carries it (theory, "Pre-tension").
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Locks off every plate that is being tensioned, with the force it has. \pre the state is an accepted equilibrium.
void lockOffPlates(const Model& model, State& state);

}  // namespace keyblock
