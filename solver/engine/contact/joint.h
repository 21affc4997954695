// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which joint a contact is part of: its material, and how far it has been
// driven apart.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Of the joint materials of two faces the weaker: less friction, and of equal friction less cohesion. Of the corner's
/// block the face that lies along the edge counts, else both beside the corner. Intact rock is what was never parted:
/// it counts where the faces met in the scene as it was given (`first`), elsewhere the blocks' own materials do.
/// \return a row of Model::joints
int governingJoint(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact, bool first);

/// Row of State::openings of the joint or set that the edge and the corner's faces beside it are on; −1: none.
int openingBetween(const Model& model, const Contact& contact);

/// How far the contact's joint is driven apart: by its material and by its name [m].
double openingOf(const std::vector<double>& openings, const Contact& contact);

/// The widest that a contact has been driven apart, by which more a search must reach [m].
double widestOpening(const State& state);

/// Gives contacts that were just found in a dilated joint the opening that it has by now; none carries force by that.
void meetDilated(const State& state, std::vector<Contact>& contacts);

}  // namespace keyblock
