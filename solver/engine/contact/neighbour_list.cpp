// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/neighbour_list.h"

#include "geometry/grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double leastSpare = 0.5;  // of the margin of the search: a list has so much beyond it at least
constexpr double mostSpare = 0.1;  // of the smallest block's size: and so much at most, even if the margin is wide
constexpr double lifetime = 32.0;  // number of searches for which a list should last
constexpr double worthwhile = 4.0;  // number of searches for which a list has to last
constexpr int pauseOfLists = 32;  // number of searches without a list where a new one would not last so long
constexpr double tooWide = 3.0;  // times the margin needed: a list with more has too many edges

Box searched(const Model& model, const Outline& outline, double margin) {
    return grown(outline.box, 0.5 * margin + model.tolerance);
}

/// What has to be near an edge for a corner to be listed.
struct Vicinity {
    double away = 0.0, deep = 0.0, past = 0.0;  // in front of it, behind it, past its ends [m]
    double spare = 0.0;  // distance by which points may move relative to each other while the list is used [m]

    /// Whether a point may come near the edge. Each end of the edge moves by half of `spare` at most, so that its unit
    /// vectors change by 2·`spare`/length at most, and the point's place along and across it by that times its distance.
    bool has(const Edge& edge, const Point& p) const {
        const Point from = p - edge.start;
        const double turned = 2.0 * spare / edge.length * from.norm();
        const double gap = edge.outward.dot(from), along = edge.along.dot(from);
        const bool isAway = gap > away + turned || gap < -deep - spare - turned;
        const bool isPast = along < -past - turned || along > edge.length + past + spare + turned;
        return !isAway && !isPast;
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
    ++searches_;
    if (!(farthest <= margin)) return false;
    if (pause_ > 0) {
        --pause_;
        return false;
    }
    const double moved = margin_ > 0.0 ? movedSince(blocks) : 0.0, largestSpare = mostSpare * model.smallest;
    if (covers(margin, 2.0 * (moved + model.tolerance), largestSpare)) return true;
    const double spare = spareFor(margin, moved, largestSpare);
    if (spare * searches_ < 2.0 * worthwhile * moved) {
        pause_ = pauseOfLists;
        margin_ = 0.0;
        return false;
    }
    make(model, blocks, outlines, margin, spare);
    return true;
}

/// True if the list has all that is within `margin` after corners have moved by up to `apart` relative to each other
/// [m], and not far more.
bool NeighbourList::covers(double margin, double apart, double largestSpare) const {
    return margin_ > 0.0 && apart <= spare_ && margin + apart <= margin_ && margin_ <= tooWide * margin + largestSpare;
}

/// Largest displacement of a corner since the list was made [m]; infinite if one is not a number.
double NeighbourList::movedSince(const std::vector<BlockMotion>& blocks) const {
    assert(places_.size() == blocks.size());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        for (std::size_t k = 0; k < places_[i].size(); ++k) {
            const double moved = (blocks[i].corners[k] - places_[i][k]).squaredNorm();
            if (!(moved < infinity)) return infinity;
            most = std::max(most, moved);
        }
    return std::sqrt(most);
}

/// What a new list has beyond the margin of the search, from the displacement since the last one was made [m].
double NeighbourList::spareFor(double margin, double moved, double largestSpare) const {
    return std::min(largestSpare, std::max(leastSpare * margin, 2.0 * lifetime * moved / searches_));
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
    const Box box = grown(outlines[b].box, 2.0 * past + spare_);
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
