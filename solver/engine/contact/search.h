// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which corners stand before which edges. Candidates come from a grid over the
// boxes of the blocks; history is found again by the pair of features, or taken
// over from a neighbour at the same place.
#pragma once

#include "solver/engine/contact/candidates.h"

#include <vector>

namespace keyblock {

/// What a search found before history decided, so that another path can be judged without a second search.
struct FoundCorners {
    /// A corner near an edge of another block. What does not depend on the path keeps its contact, if it has one.
    struct Corner {
        int a = -1, corner = -1, b = -1;
        bool byPath = false;
        std::vector<Contact> found;
    };
    double margin = 0.0;  // of the search [m]
    std::vector<Outline> outlines;  // of the blocks where it was made
    std::vector<std::vector<Corner>> pairs;
};

/// What a search goes by.
struct ContactSearch {
    double margin = 0.0;  // [m] how near a corner must be
    bool first = false;  // the scene as it was given: faces that touch carry no force, joints may be bonded
    bool underWay = false;  // the blocks have moved since their forces were accepted
    const Eigen::VectorXd* path = nullptr;  // displacement of the step that begins; none: at rest
    double* released = nullptr;  // takes the elastic energy of contacts that ended or changed [J]
    FoundCorners* corners = nullptr;  // takes what was found
};

/// Contacts closer than the margin, sorted by block pair and corner, with the history of `before`.
/// One spring per corner pair: where a corner of each lies on an edge of the other at the same
/// place, the one with history is kept, else the one further inside.
std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, const ContactSearch& search);

/// The same from a margin and the question whether it is the scene as it was given.
std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, double margin, bool first);

/// False where a corner comes in by another edge than it was looked for, now that its path is known. `found` is of the
/// search for `contacts` from where the blocks still are; the other searches once more with the same margin.
bool entrancesHold(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& contacts,
                   const FoundCorners& found, const Eigen::VectorXd& path);
bool entrancesHold(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& contacts,
                   double margin, const Eigen::VectorXd& path);

}  // namespace keyblock
