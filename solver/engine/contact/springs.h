// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of a contact: a compression-only spring normal to the edge and a spring along
// the edge that is limited by friction. With the augmented Lagrangian method the springs
// serve only to find the forces and store no energy.
#pragma once

#include "solver/engine/model/state.h"

#include <utility>
#include <vector>

namespace keyblock {

/// Point of block A at which a contact acts [m]: its corner, or a point on a bonded face.
Point contactPoint(const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Position of the contact point along the edge of block B, as a fraction of the edge's length.
double placeOnEdge(const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Gap and slip of a contact at the current block positions [m].
double gapOf(const std::vector<BlockMotion>& blocks, const Contact& contact);
double slipOf(const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Gap and slip together [m].
struct ContactStrains {
    double gap = 0.0, slip = 0.0;
};
ContactStrains strainsOf(const std::vector<BlockMotion>& blocks, const Contact& contact);

/// True if the contact uses multipliers and needs no penetration to carry force. This excludes joints for which a
/// stiffness is specified and the ends of joined bonded faces, because these deform according to their stiffness.
bool isAugmented(const Model& model, const Contact& contact);

/// Spring stiffnesses of a contact [N/m].
struct ContactSprings {
    double normal = 0.0, shear = 0.0;
};

/// Spring stiffnesses of a contact. The normal stiffness is penalty ratio · E · thickness, with the smaller E of the
/// two blocks, and the shear stiffness is the shear ratio times the normal stiffness. If faces meet and a stiffness is
/// specified for their joint material, the spring stiffness is instead the joint stiffness times the contact's length
/// and the thickness.
ContactSprings contactSprings(const Model& model, const Contact& contact);

/// Gap at which the normal spring of a contact carries no force, and slip at which the shear spring carries no force
/// [m].
std::pair<double, double> zeroPoints(const Contact& contact, const ContactSprings& springs);

/// Tangent of the current friction angle, which is the residual angle after the first slip.
double frictionOf(const Model& model, const Contact& contact);

/// Set the zero point or multiplier of the normal or shear spring so that the contact carries the given force at the
/// current block positions.
/// \param strain the current gap (normal) or slip (shear) [m].
/// \param force the compression (normal) or the force along the edge (shear) [N].
void carryNormal(const Model& model, Contact& contact, double strain, double force);
void carryShear(const Model& model, Contact& contact, double strain, double force);

/// Compression, and force along the edge [N].
struct ContactForces {
    double normal = 0.0, shear = 0.0;
};

/// Forces of the contact's laws at the current block positions, with friction limited by the current compression.
ContactForces forcesNow(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact);

/// Adds `more` to the forces that the contact carries at the current block positions.
void addForces(const Model& model, Contact& contact, const ContactForces& more);

/// Elastic energy of the contact at the current block positions [J].
double contactEnergy(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact);

}  // namespace keyblock
