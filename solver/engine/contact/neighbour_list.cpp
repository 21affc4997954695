// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/neighbour_list.h"

#include "geometry/grid.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

// What a list has beyond the margin of the search: at most this share of the smallest block's size, and up to that at
// least this share of the margin
constexpr double leastSpare = 0.5, mostSpare = 0.1;
constexpr double lifetime = 32.0;  // number of searches for which a list should last
constexpr double worthwhile = 4.0;  // number of searches for which it has to last
constexpr int pauseOfLists = 32;  // number of searches after a list that would not
constexpr double tooWide = 3.0;  // times the margin needed: a list with more has too many edges

Box searched(const Model& model, const Outline& outline, double margin) {
    return grown(outline.box, 0.5 * margin + model.tolerance);
}

/// What has to be near an edge for a corner to be listed.
struct Vicinity {
    double away = 0.0, deep = 0.0, past = 0.0;  // in front of it, behind it, past its ends [m]
    double spare = 0.0;  // distance by which points may move relative to each other while the list is used [m]

    /// Whether a point may come near the edge. A turn of the edge moves its line more, the farther it is from the edge.
    bool has(const Edge& edge, const Point& p) const {
        const Point from = p - edge.start;
        const double more = spare + 2.0 * spare / edge.length * from.norm();
        const double gap = edge.outward.dot(from), along = edge.along.dot(from);
        return gap <= away + more && gap >= -deep - more && along >= -past - more && along <= edge.length + past + more;
    }
};

}  // namespace

BlockPairs pairsWithin(const Model& model, const std::vector<Outline>& outlines, double margin) {
    std::vector<Box> boxes;
    boxes.reserve(outlines.size());
    for (const Outline& outline : outlines) boxes.push_back(searched(model, outline, margin));
    BlockPairs pairs = BoxGrid(std::move(boxes)).meetingPairs();
    std::erase_if(pairs, [&](const auto& p) { return sameRock(model, p.first, p.second); });
    return pairs;
}

bool areWithin(const Model& model, const Outline& a, const Outline& b, double margin) {
    return meets(searched(model, a, margin), searched(model, b, margin));
}

bool NeighbourList::prepare(const Model& model, const std::vector<BlockMotion>& blocks,
                            const std::vector<Outline>& outlines, double margin, double farthest) {
    if (farthest > margin) return false;  // a corner may come near edges beyond the margin
    if (pause_ > 0) {
        --pause_;
        return false;
    }
    const double moved = margin_ > 0.0 ? movedSince(blocks) : 0.0, most = mostSpare * model.smallest;
    if (!isFor(margin, 2.0 * (moved + model.tolerance), most)) {
        const double spare = spareFor(margin, moved, most);
        if (spare * searches_ < 2.0 * worthwhile * moved) {
            pause_ = pauseOfLists;
            margin_ = 0.0;
            return false;
        }
        make(model, blocks, outlines, margin, spare);
    }
    ++searches_;
    return true;
}

/// True if the list has all that is within `margin` after corners have moved by up to `apart` relative to each other
/// [m], and not far more.
bool NeighbourList::isFor(double margin, double apart, double most) const {
    return margin_ > 0.0 && apart <= spare_ && margin + apart <= margin_ && margin_ <= tooWide * margin + most;
}

/// Largest displacement of a corner since the list was made [m].
double NeighbourList::movedSince(const std::vector<BlockMotion>& blocks) const {
    double most = 0.0;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        for (std::size_t k = 0; k < places_[i].size(); ++k)
            most = std::max(most, (blocks[i].corners[k] - places_[i][k]).squaredNorm());
    return std::sqrt(most);
}

/// What a new list has beyond the margin of the search, from the displacement since the last one was made [m].
double NeighbourList::spareFor(double margin, double moved, double most) const {
    const double pace = moved / std::max(1, searches_);
    return std::min(most, std::max(leastSpare * margin, 2.0 * lifetime * pace));
}

void NeighbourList::make(const Model& model, const std::vector<BlockMotion>& blocks,
                         const std::vector<Outline>& outlines, double margin, double spare) {
    margin_ = margin + spare;
    spare_ = spare;
    searches_ = 0;
    places_.resize(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) places_[i] = blocks[i].corners;
    pairs_.clear();
    corners_.clear();
    turns_.clear();
    for (const auto& [a, b] : pairsWithin(model, outlines, margin_)) {
        Pair pair{a, b, std::ssize(corners_)};
        addCorners(model, blocks, outlines, a, b);
        addCorners(model, blocks, outlines, b, a);
        pair.end = std::ssize(corners_);
        pairs_.push_back(pair);
    }
}

/// Adds the corners of block `a` that may come near edges of block `b`.
void NeighbourList::addCorners(const Model& model, const std::vector<BlockMotion>& blocks,
                               const std::vector<Outline>& outlines, int a, int b) {
    const double past = slackBetween(model, a, b) + margin_;
    const Vicinity vicinity{margin_, deepestNear(model.blocks[b]), past, spare_};
    const Box box = grown(outlines[b].box, vicinity.deep + 2.0 * past + spare_);
    for (const int corner : model.blocks[a].turns) {
        const Point& place = blocks[a].corners[corner];
        if (!meets(box, {place, place})) continue;
        Corner found{a, corner, b, std::ssize(turns_)};
        for (int turn = 0; turn < std::ssize(outlines[b].runs); ++turn)
            if (vicinity.has(outlines[b].runs[turn], place)) turns_.push_back(turn);
        found.end = std::ssize(turns_);
        if (found.begin < found.end) corners_.push_back(found);
    }
}

}  // namespace keyblock
