// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bonded joints on faces of cells, which carry bending. The stress in a cell is
// constant, so two stiff springs at the ends of its face would keep the face straight
// and attract forces that do not exist in the rock. The springs therefore act nearer
// the middle of the face, where their rotational stiffness matches that of the adjacent
// cells. The strength of the bond is checked with the traction at the ends of the face
// (theory, "Contacts").
#pragma once

#include "solver/engine/contact/springs.h"
#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Joins the two bonded contacts at the ends of each face of a cell, keeping their resultant and moment. Other
/// contacts, and faces already joined, are not changed.
/// \return the decrease in elastic energy [J].
double joinBondedFaces(const Model& model, const std::vector<BlockMotion>& blocks, std::vector<Contact>& contacts);

/// Separates the joined pair to which `contact` belongs, so that both contacts act at their corners again with the same
/// resultant and moment. A contact that is not joined is not changed.
/// \return the decrease in elastic energy [J].
double partBondedFace(const Model& model, const std::vector<BlockMotion>& blocks, std::vector<Contact>& contacts,
                      Contact& contact);

/// Forces of the contact referred to its corner [N]. If its face is joined, the joined pair is replaced by two forces
/// at the ends of the face with the same resultant and moment; those at the contact's end are returned.
ContactForces forcesAtCorner(const std::vector<Contact>& contacts, const Contact& contact);

/// Compression at the contact's corner [N]: the normal traction there times the contact's length and the thickness.
double edgeCompression(const std::vector<Contact>& contacts, const Contact& contact);

}  // namespace keyblock
