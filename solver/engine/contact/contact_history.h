// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What contacts remember. History follows the pair of features; where a corner
// slides off the end of its edge, the contact that takes its place takes its
// force over, so that a surface cut into pieces is felt as one.
#pragma once

#include "solver/engine/model/state.h"

#include <span>
#include <vector>

namespace keyblock {

/// A contact's own history, or what a contact without any starts with. \return elastic energy that it lost [J].
double giveHistory(const Model& model, const std::vector<BlockMotion>& blocks, std::span<const Contact> before,
                   bool first, Contact& contact);

/// Tributary length of joint of the contact where the blocks are: half of what a face of its corner shares with the
/// edge, 0 where none lies along it [m].
double lengthOfJoint(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Hands the forces of contacts that slid off their edges on to those found at the same place, and keeps bonded ones.
/// \param underWay the blocks have moved since forces were accepted: what counts is what the laws give now.
/// \param found sorted; stays so. \return elastic energy that was lost [J].
double handOver(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& before,
                bool underWay, std::vector<Contact>& found);

}  // namespace keyblock
