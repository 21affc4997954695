// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// History of contacts. It belongs to the pair of corner and edge. If a corner slides
// off the end of its edge, its force is transferred to the contact that replaces it, so
// that a surface divided into several edges behaves as one.
#pragma once

#include "solver/engine/contact/candidates.h"

#include <span>
#include <vector>

namespace keyblock {

/// The contact of a candidate that had none before.
/// \param first true for the original scene, in which touching faces carry no force and joints may be bonded.
Contact newContact(const Model& model, const std::vector<BlockMotion>& blocks, bool first, const Candidate& candidate);

/// The contact of a candidate with its history from `before`; without one, a new contact.
/// \param released is increased by the decrease in elastic energy [J].
Contact contactOf(const Model& model, const std::vector<BlockMotion>& blocks, std::span<const Contact> before,
                  bool first, const Candidate& candidate, double& released);

/// Tributary joint length of the contact at the current block positions [m]: half of the length that a face at its
/// corner shares with the edge; 0 if no such face lies along the edge.
double lengthOfJoint(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Transfers the forces of contacts that slid off their edges to contacts found at the same position, and adds bonded
/// contacts that the search did not find again.
/// \param underWay true if the blocks have moved since forces were accepted; the current forces of the laws are then
/// transferred.
/// \param found the contacts found, sorted; they remain sorted.
/// \return the decrease in elastic energy [J].
double handOver(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& before,
                bool underWay, std::vector<Contact>& found);

}  // namespace keyblock
