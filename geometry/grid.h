// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the pairs of boxes that meet, in time proportional to their number. Each box is
// stored in a uniform grid whose cell size is about its own size, so that a large slab
// among small blocks costs no more than another small block.
#pragma once

#include "geometry/polygon.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace keyblock {

class BoxGrid {
public:
    /// \pre all coordinates are finite.
    explicit BoxGrid(std::vector<Box> boxes);

    /// All pairs i < j of boxes that touch or overlap, sorted.
    std::vector<std::pair<int, int>> meetingPairs() const;

    /// The indices of the boxes that touch or overlap `box`, sorted.
    std::vector<int> meeting(const Box& box) const;

    /// The number of boxes that `meeting` compares with `box`.
    std::size_t compared(const Box& box) const;

private:
    struct Entry {
        std::int64_t row = 0;  // of the cell with the lower left corner of the box
        std::int64_t column = 0;
        int box = 0;
    };
    /// Boxes of similar size in a uniform grid; no box is larger than a grid cell.
    struct Level {
        double cell = 0.0;  // [m]
        std::vector<Entry> entries;  // sorted by row, column, box
    };

    template <class Visit>
    void visitCells(const Level& level, const Box& box, Visit visit) const;
    template <class Visit>
    void visitMeeting(const Level& level, const Box& box, Visit visit) const;
    void addPairsWithin(const Level& level, std::vector<std::pair<int, int>>& pairs) const;
    std::int64_t cellIndex(double offset, double cell) const;

    std::vector<Box> boxes_;
    Point origin_{0.0, 0.0};
    std::vector<Level> levels_;  // in increasing order of cell size
};

}  // namespace keyblock
