// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which corners stand before which edges. Candidates come from a grid over the
// boxes of the blocks; history is found again by the pair of features, or taken
// over from a neighbour at the same place.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// What a search goes by.
struct ContactSearch {
    double margin = 0.0;  // [m] how near a corner must be
    bool first = false;  // the scene as it was given: faces that touch carry no force, joints may be bonded
    bool underWay = false;  // the blocks have moved since their forces were accepted
    const Eigen::VectorXd* path = nullptr;  // displacement of the step that begins; none: at rest
    double* released = nullptr;  // takes the elastic energy of contacts that ended or changed [J]
};

/// Contacts closer than the margin, sorted by block pair and corner, with the history of `before`.
/// One spring per corner pair: where a corner of each lies on an edge of the other at the same
/// place, the one with history is kept, else the one further inside.
std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, const ContactSearch& search);

/// The same from a margin and the question whether it is the scene as it was given.
std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, double margin, bool first);

/// Contacts that were just found in a dilated joint stand where its faces are by now; none carries force by that.
void meetDilated(const State& state, std::vector<Contact>& contacts);

/// False where a corner comes in by another edge than it was looked for, now that its path is known.
bool entrancesHold(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& contacts,
                   double margin, const Eigen::VectorXd& path);

/// An edge of a block as it is now: start, unit direction, outward normal, length [m].
struct Edge {
    Point start{0.0, 0.0}, along{1.0, 0.0}, outward{0.0, -1.0};
    double length = 0.0;
};
Edge edgeOf(const std::vector<Point>& corners, int index);

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

/// Springs of one contact [N/m].
struct ContactSprings {
    double normal = 0.0, shear = 0.0;
};

/// Penalty ratio · E · thickness, E the smaller of the two blocks', and its shear share; or, where faces meet and their
/// joint material has a stiffness of its own, that times the contact's length and the thickness.
ContactSprings contactSprings(const Model& model, const Contact& contact);

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

/// Gap and slip of a contact where the blocks are [m].
double gapOf(const std::vector<BlockMotion>& blocks, const Contact& contact);
double slipOf(const std::vector<BlockMotion>& blocks, const Contact& contact);

}  // namespace keyblock
