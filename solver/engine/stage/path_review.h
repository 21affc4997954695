// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What happened between two equilibria, to choose how much load is put on at once.
//
// Friction is satisfied at the end of an increment. That is the state which many
// short increments reach as long as each contact keeps to the way it began: it
// sticks, or slides in one direction to the end. A contact that slid and then
// sticks or turns back somewhere within the increment carries a shear force that
// depends on the path; how much, is estimated from how fast it slid before.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

struct PathReview {
    bool straight = true;  // forces and displacements follow straight lines: no contact or bolt changed its behaviour
    bool boltsFlow = false;  // steel, an anchor or its rock flows, slides or sticks again, or changes its block
    double error = 0.0;  // largest estimated error over what is allowed
};

/// \param before, after equilibria at the ends of the increment. \param ratio length of the increment over that of the
/// one before it; 0: the load turned or something failed in between, so that contacts may stick from the start.
PathReview reviewPath(const Model& model, const State& before, const State& after, double ratio);

}  // namespace keyblock
