// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A neighbour list (Verlet 1967): the pairs of blocks, and for each corner the edges,
// that a contact search has to look at. It is made with more than the margin of the
// search and used until the blocks have moved by the difference. A search with the list
// has the same result as one without.
#pragma once

#include "solver/engine/contact/candidates.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace keyblock {

using BlockPairs = std::vector<std::pair<int, int>>;

/// Pairs of blocks, the smaller number first, that are not the same rock and whose boxes, each enlarged by half of
/// `margin` [m] and the tolerance of the model, meet. Sorted.
BlockPairs pairsWithin(const Model& model, const std::vector<Outline>& outlines, double margin);

/// True if `pairsWithin` finds two blocks with these outlines.
bool areWithin(const Model& model, const Outline& a, const Outline& b, double margin);

class NeighbourList {
public:
    /// A corner of one block of a pair near edges of the other.
    struct Corner {
        int block = -1, corner = -1, other = -1;
        std::ptrdiff_t begin = 0, end = 0;  // the edges, as a range of the list of turns
    };
    struct Pair {
        int a = -1, b = -1;
        std::ptrdiff_t begin = 0, end = 0;  // the corners, as a range of the list of corners
    };

    /// Makes the list ready for a search with this margin [m].
    /// \param farthest upper bound of the displacement of a corner relative to a block near it, on the path of the search
    /// [m].
    /// \return whether the list may be used. It may not if `farthest` is more than the margin, because corners may then
    /// come near other edges; nor does it pay if blocks move far from search to search.
    /// \pre the model is the same in all calls.
    bool prepare(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Outline>& outlines,
                 double margin, double farthest);

    /// At least the pairs that `pairsWithin` finds with the margin of the search, in the same order.
    std::span<const Pair> pairs() const { return pairs_; }

    /// At least the corners that `CandidateSearch::addNearEdges` finds near an edge: those of block `a` first, each in the
    /// order of its turns.
    std::span<const Corner> corners(const Pair& pair) const {
        return {corners_.begin() + pair.begin, corners_.begin() + pair.end};
    }

    /// At least the edges that the corner is near, as indices of BlockModel::turns in ascending order.
    std::span<const int> turns(const Corner& corner) const {
        return {turns_.begin() + corner.begin, turns_.begin() + corner.end};
    }

    /// Number of searches since the list was made.
    int searches() const { return searches_; }

private:
    bool covers(double margin, double apart, double largestSpare) const;
    double movedSince(const std::vector<BlockMotion>& blocks) const;
    double spareFor(double margin, double moved, double largestSpare) const;
    void make(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Outline>& outlines,
              double margin, double spare);
    void addCorners(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Outline>& outlines,
                    int a, int b);

    double margin_ = 0.0;  // with which the list was made [m]; 0: there is none
    double spare_ = 0.0;  // the part of it beyond the margin of the search at that time [m]
    std::vector<std::vector<Point>> places_;  // the corners of all blocks at that time [m]
    std::vector<Pair> pairs_;
    std::vector<Corner> corners_;
    std::vector<int> turns_;
    int searches_ = 0;
    int pause_ = 0;  // number of searches without a list before the next one is made
};

}  // namespace keyblock
