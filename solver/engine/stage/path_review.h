// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Review of the path between two equilibria, used to choose the load increment.
//
// Friction is satisfied at the end of an increment. Many short increments would lead to
// the same state if each contact behaves in the same way throughout: it sticks, or it
// slides in one direction to the end. If a contact slides at first and then sticks or
// reverses within the increment, its shear force depends on the path. The error is
// estimated from the sliding in the previous increment.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

struct PathReview {
    bool straight = true;  // forces and displacements vary linearly: no contact or bolt changed its behaviour
    bool boltsFlow = false;  // a bolt's steel, bond or rock yielded, slipped or re-stuck, or a node changed block
    double error = 0.0;  // largest estimated error of forces over the allowed error
    double turn = 0.0;  // largest rotation of a block over the allowed rotation
};

/// Compares the equilibria at the two ends of an increment.
/// \param before, after the equilibria at the start and the end.
/// \param ratio the length of the increment divided by the length of the previous increment; 0 if the load changed
/// direction, something failed in between or a block jumped in the previous increment, so that contacts may stick from
/// the start.
PathReview reviewPath(const Model& model, const State& before, const State& after, double ratio);

}  // namespace keyblock
