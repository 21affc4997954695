// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The joint to which a contact belongs: its material and its prescribed opening.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Governing joint material of a contact: the weaker of its faces' materials, i.e. the material with the lower friction
/// or, if friction is equal, the lower cohesion. On the corner's block, the face that lies along the edge is
/// considered, or both faces at the corner if neither lies along it. A face of intact rock counts as intact only where
/// faces meet in the original scene; otherwise the block's own joint material is used instead.
/// \param first true for the original scene
/// \return an index into Model::joints.
int governingJoint(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact, bool first);

/// Index into State::openings of the joint or joint set to which both the edge and a face at the corner belong; −1:
/// none.
int openingBetween(const Model& model, const Contact& contact);

/// Prescribed opening of the contact's joint [m]: the opening of its material plus the opening of its named joint or
/// joint set.
/// \param openings as in State::openings
double openingOf(const std::vector<double>& openings, const Contact& contact);

/// Largest joint opening applied to any contact so far [m]; the search margin for contacts must be increased by this
/// amount.
double widestOpening(const State& state);

/// Gives newly found contacts in a dilated joint the joint's current opening, without creating contact forces.
void meetDilated(const State& state, std::vector<Contact>& contacts);

}  // namespace keyblock
