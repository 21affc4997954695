// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which corners stand before which edges. Candidates come from a grid over the
// boxes of the blocks; history is found again by the pair of features.
#pragma once

#include "solver/engine/state.h"

#include <vector>

namespace keyblock {

/// Contacts closer than `margin` [m], sorted by block pair and corner, with the history of `before`.
/// One spring per corner pair: where a corner of each lies on an edge of the other at the same
/// place, the one with history is kept, else the one further inside.
/// \param first true for the scene as it was given: faces that touch carry no force there,
///        and joints with cohesion or tension are bonded.
std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, double margin, bool first);

/// An edge of a block as it is now: start, unit direction, outward normal, length [m].
struct Edge {
    Point start{0.0, 0.0}, along{1.0, 0.0}, outward{0.0, -1.0};
    double length = 0.0;
};
Edge edgeOf(const std::vector<Point>& corners, int index);

/// Of the joint materials of two blocks the weaker: less friction, and of equal friction less cohesion.
/// \return a row of Model::joints
int governingJoint(const Model& model, int blockA, int blockB);

/// Contact stiffness of a pair: penalty ratio · E · thickness, E the smaller of the two [N/m].
double contactStiffness(const Model& model, int blockA, int blockB);

}  // namespace keyblock
