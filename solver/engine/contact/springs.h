// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of a contact: a spring that only pushes across the edge, and one along
// it that friction limits. With an augmented Lagrangian the springs only find the
// forces and store nothing.
#pragma once

#include "solver/engine/model/state.h"

#include <utility>
#include <vector>

namespace keyblock {

/// Where a contact acts on block A: its corner, or a place on a bonded face [m].
Point contactPoint(const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Share of the edge of block B at which that lies.
double placeOnEdge(const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Gap and slip of a contact where the blocks are [m].
double gapOf(const std::vector<BlockMotion>& blocks, const Contact& contact);
double slipOf(const std::vector<BlockMotion>& blocks, const Contact& contact);

/// True where the scene asks for multipliers and the contact is no joint with a stiffness of its own and no end of a
/// bonded face: those deform by their stiffness, other contacts need no penetration to carry force.
bool isAugmented(const Model& model, const Contact& contact);

/// Springs of one contact [N/m].
struct ContactSprings {
    double normal = 0.0, shear = 0.0;
};

/// Penalty ratio · E · thickness, E the smaller of the two blocks', and its shear share; or, where faces meet and their
/// joint material has a stiffness of its own, that times the contact's length and the thickness.
ContactSprings contactSprings(const Model& model, const Contact& contact);

/// Gap and slip at which normal and shear spring of a contact carry nothing [m].
std::pair<double, double> zeroPoints(const Contact& contact, const ContactSprings& springs);

/// Tangent of the friction angle that acts: the residual one after the first slip.
double frictionOf(const Model& model, const Contact& contact);

/// Zero points or multipliers such that the contact carries a force where the blocks are.
/// \param strain gap or slip of its link there [m]; \param force compression, or along the edge [N].
void carryNormal(const Model& model, Contact& contact, double strain, double force);
void carryShear(const Model& model, Contact& contact, double strain, double force);

/// Compression, and force along the edge [N].
struct ContactForces {
    double normal = 0.0, shear = 0.0;
};

/// What the contact's laws give where the blocks are; friction up to what the compression there lets it hold.
ContactForces forcesNow(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Makes the contact carry more where the blocks are.
void addForces(const Model& model, Contact& contact, const ContactForces& more);

/// Elastic energy of the contact where the blocks are [J].
double contactEnergy(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact);

}  // namespace keyblock
