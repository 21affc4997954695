// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact search: finds the corners that face edges of other blocks. Candidate pairs of
// blocks come from a grid over their bounding boxes, or from a neighbour list made with
// it. History is matched by the pair of corner and edge, or taken over from a contact at
// the same position.
#pragma once

#include "solver/engine/contact/neighbour_list.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace keyblock {

/// Result of a search before contacts take over their history. The contacts for another path can be derived from it
/// without a new search.
struct FoundCorners {
    /// A corner near edges of another block.
    struct Corner {
        int a = -1, corner = -1, b = -1;
        std::ptrdiff_t begin = 0, end = 0;  // the edges, as a range of `Batch::near`
    };
    /// Two blocks near each other.
    struct Pair {
        int a = -1, b = -1;
        std::ptrdiff_t begin = 0, end = 0;  // their corners, as a range of `Batch::corners`
        /// Change of the relative displacement up to which their contacts are the same [m].
        double allowedChange = std::numeric_limits<double>::infinity();
    };
    /// Pairs that are searched one after the other, with their corners.
    struct Batch {
        std::vector<Pair> pairs;
        std::vector<Corner> corners;
        std::vector<NearEdge> near;
    };
    double margin = 0.0;  // margin of the search [m]
    std::vector<Drift> drift;  // displacement of each block over the path of the search; zero if it had none
    std::vector<Outline> outlines;  // outlines of the blocks in the search
    Standings standings;  // corners that were supported before the search
    std::vector<Batch> batches;  // all pairs of blocks near each other
};

/// Options of a contact search.
struct ContactSearch {
    double margin = 0.0;  // largest distance of a corner from an edge [m]
    bool first = false;  // original scene: touching faces carry no force, and joints may be bonded
    bool underWay = false;  // the blocks have moved since their forces were accepted
    const Eigen::VectorXd* path = nullptr;  // displacement over the coming step; null: at rest
    double* released = nullptr;  // receives the elastic energy released by contacts that ended or changed [J]
    FoundCorners* corners = nullptr;  // receives the corners found
    bool estimated = false;  // the path is an estimate: a corner at another corner keeps the edge of its last contact
    NeighbourList* neighbours = nullptr;  // kept from search to search; it does not change the result
};

/// Finds the contacts within the margin, sorted by block pair, corner and edge, with the history from `before`. If two
/// corners at the same position each lie on an edge of the other block, there are two contacts for the same pair of
/// corners. If neither of them has a history, only the one with the larger penetration is kept; otherwise, only
/// contacts with a history are kept.
std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, const ContactSearch& search);

/// Finds contacts with the given margin and default options; `first` is true for the original scene.
std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, double margin, bool first);

/// Checks `contacts` against a displacement `path` that was not known when they were found: false if a corner would
/// enter a block through an edge other than the one in `contacts`.
/// \param deep a corner that would be no deeper than this share of the smaller block's size does not count; with 0, the
/// tolerance of the model applies.
/// \param found the corners found by the search for `contacts`.
/// The supported corners are those before that search, the forces those of `contacts`.
/// \pre the blocks have not moved since that search.
bool entrancesHold(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& contacts,
                   const FoundCorners& found, const Eigen::VectorXd& path, double deep = 0.0);

}  // namespace keyblock
