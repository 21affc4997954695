// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bonded joint on a face of a cell carries bending. Stress is constant in a cell,
// so two stiff springs at the ends of its face would hold the face straight and draw
// forces that the rock does not have. The springs act nearer the middle instead, where
// they are as stiff in turning as the cells beside the face, and the bond is judged by
// the traction at the ends of the face (theory, "Contacts").
#pragma once

#include "solver/engine/contact/springs.h"
#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Joins the bonded contacts at the two ends of each face of a cell; their forces stay, as a resultant and a moment.
/// Others, and faces that are joined already, stay as they are. \return elastic energy that this takes away [J].
double joinBondedFaces(const Model& model, const std::vector<BlockMotion>& blocks, std::vector<Contact>& contacts);

/// Both contacts of a face act at their corners again, under the same resultant and moment. Contacts that are not
/// joined stay as they are. \return elastic energy that this takes away [J].
double partBondedFace(const Model& model, const std::vector<BlockMotion>& blocks, std::vector<Contact>& contacts,
                      Contact& contact);

/// What the contact carries, as seen at its corner: of a joined face, the forces at its two ends that have its resultant
/// and its moment [N].
ContactForces forcesAtCorner(const std::vector<Contact>& contacts, const Contact& contact);

/// Compression at the contact's corner: the traction there times the contact's length and the thickness [N].
double edgeCompression(const std::vector<Contact>& contacts, const Contact& contact);

}  // namespace keyblock
