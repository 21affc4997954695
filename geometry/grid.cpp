// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cell size doubles from level to level, and no box is larger than the cells of its level. So if a box meets
// another one, its lower left corner lies in a cell that the other box covers, or in the next cell to the left or
// below. These cells are a few runs of a sorted list. Pairs are searched from the finer to the coarser level, so each
// pair is found once.
#include "geometry/grid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace keyblock {

namespace {

using Pairs = std::vector<std::pair<int, int>>;

double largerSide(const Box& box) { return (box.max - box.min).maxCoeff(); }

/// Exponent of the cell size for a box of this size. The relative margin of 1e-6 covers the round-off of cell indices
/// up to a billion, so that boxes that just touch are never missed.
int levelOf(double size) {
    int exponent = 0;
    std::frexp(size * (1.0 + 1e-6), &exponent);
    return exponent;
}

/// The pairs in order: counted by their first index, then sorted by the second. Faster than sorting all pairs, since an
/// index has few of them. \param end larger than every index.
Pairs inOrder(const Pairs& pairs, std::size_t end) {
    std::vector<std::ptrdiff_t> first(end + 1, 0);
    for (const auto& pair : pairs) ++first[pair.first + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    Pairs ordered(pairs.size());
    std::vector<std::ptrdiff_t> next = first;
    for (const auto& pair : pairs) ordered[next[pair.first]++] = pair;
    for (std::size_t i = 0; i < end; ++i) std::sort(ordered.begin() + first[i], ordered.begin() + first[i + 1]);
    return ordered;
}

}  // namespace

BoxGrid::BoxGrid(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) return;
    Box all = boxes_.front();
    for (const Box& box : boxes_) {
        all.min = all.min.cwiseMin(box.min);
        all.max = all.max.cwiseMax(box.max);
    }
    origin_ = all.min;
    // Points and tiny boxes share cells of a billionth of the whole extent, so that indices stay exact.
    const double least = std::max(1e-9 * largerSide(all), 1e-300);

    std::map<int, Level> byExponent;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const int exponent = levelOf(std::max(largerSide(boxes_[i]), least));
        Level& level = byExponent[exponent];
        level.cell = std::ldexp(1.0, exponent);
        const Point offset = boxes_[i].min - origin_;
        level.entries.push_back(
            {cellIndex(offset.y(), level.cell), cellIndex(offset.x(), level.cell), static_cast<int>(i)});
    }
    for (auto& [exponent, level] : byExponent) {
        std::sort(level.entries.begin(), level.entries.end(), [](const Entry& a, const Entry& b) {
            return std::tie(a.row, a.column, a.box) < std::tie(b.row, b.column, b.box);
        });
        levels_.push_back(std::move(level));
    }
}

std::int64_t BoxGrid::cellIndex(double offset, double cell) const {
    constexpr double farthest = 4e18;  // keeps the index of a query far outside within the integer range
    const double index = std::floor(offset / cell);  // not a number where positions of a failing run are none
    return static_cast<std::int64_t>(std::isnan(index) ? farthest : std::clamp(index, -farthest, farthest));
}

/// Visits all boxes in the cells that can contain boxes meeting `box`.
template <class Visit>
void BoxGrid::visitCells(const Level& level, const Box& box, Visit visit) const {
    const Point low = box.min - origin_;
    const Point high = box.max - origin_;
    const std::int64_t firstColumn = cellIndex(low.x(), level.cell) - 1;
    const std::int64_t lastColumn = cellIndex(high.x(), level.cell);
    const std::int64_t lastRow = cellIndex(high.y(), level.cell);

    const auto startOf = [&](std::int64_t row) {
        return std::lower_bound(level.entries.begin(), level.entries.end(), std::pair(row, firstColumn),
                                [](const Entry& entry, const std::pair<std::int64_t, std::int64_t>& key) {
                                    return std::pair(entry.row, entry.column) < key;
                                });
    };
    auto entry = startOf(cellIndex(low.y(), level.cell) - 1);
    while (entry != level.entries.end() && entry->row <= lastRow) {
        if (entry->column < firstColumn) {
            entry = startOf(entry->row);
        } else if (entry->column > lastColumn) {
            entry = startOf(entry->row + 1);
        } else {
            visit(entry->box);
            ++entry;
        }
    }
}

template <class Visit>
void BoxGrid::visitMeeting(const Level& level, const Box& box, Visit visit) const {
    visitCells(level, box, [&](int other) {
        if (meets(boxes_[other], box)) visit(other);
    });
}

/// Adds the pairs of boxes of a level that meet. A box is compared only with later boxes of the list: those in its own
/// cell, in the next cell of its row, and in the three adjacent cells of the next row. The position of the first of
/// these three only increases from box to box.
void BoxGrid::addPairsWithin(const Level& level, std::vector<std::pair<int, int>>& pairs) const {
    const auto end = level.entries.end();
    auto above = level.entries.begin();
    for (auto own = level.entries.begin(); own != end; ++own) {
        const auto addOfRow = [&](auto entry, std::int64_t row) {
            for (; entry != end && entry->row == row && entry->column <= own->column + 1; ++entry)
                if (meets(boxes_[entry->box], boxes_[own->box])) pairs.emplace_back(std::minmax(entry->box, own->box));
        };
        addOfRow(own + 1, own->row);
        const auto first = std::pair(own->row + 1, own->column - 1);
        while (above != end && std::pair(above->row, above->column) < first) ++above;
        addOfRow(above, own->row + 1);
    }
}

std::vector<std::pair<int, int>> BoxGrid::meetingPairs() const {
    std::vector<std::pair<int, int>> pairs;
    for (auto own = levels_.begin(); own != levels_.end(); ++own) {
        addPairsWithin(*own, pairs);
        for (const Entry& entry : own->entries)
            for (auto level = own + 1; level != levels_.end(); ++level)
                visitMeeting(*level, boxes_[entry.box],
                             [&](int other) { pairs.emplace_back(std::minmax(entry.box, other)); });
    }
    return inOrder(pairs, boxes_.size());
}

std::vector<int> BoxGrid::meeting(const Box& box) const {
    std::vector<int> found;
    for (const Level& level : levels_) visitMeeting(level, box, [&](int other) { found.push_back(other); });
    std::sort(found.begin(), found.end());
    return found;
}

std::size_t BoxGrid::compared(const Box& box) const {
    std::size_t count = 0;
    for (const Level& level : levels_) visitCells(level, box, [&](int) { ++count; });
    return count;
}

}  // namespace keyblock
