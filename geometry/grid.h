// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which boxes come near each other, in time proportional to their number. Every
// box lies in one cell of a uniform grid whose cells are about its own size, so a
// base slab among pebbles costs no more than another pebble.
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

    /// All pairs i < j of boxes that meet, sorted: the same for the same boxes, always.
    std::vector<std::pair<int, int>> meetingPairs() const;

    /// The boxes that meet `box`, sorted.
    std::vector<int> meeting(const Box& box) const;

    /// The number of boxes that `meeting` compares with `box`.
    std::size_t compared(const Box& box) const;

private:
    struct Entry {
        std::int64_t row = 0;  // of the cell that holds the lower left corner of the box
        std::int64_t column = 0;
        int box = 0;
    };
    /// Boxes larger than half a cell and at most as large as one.
    struct Level {
        double cell = 0.0;  // [m]
        std::vector<Entry> entries;  // by row, column, box
    };

    template <class Visit>
    void visitCells(const Level& level, const Box& box, Visit visit) const;
    template <class Visit>
    void visitMeeting(const Level& level, const Box& box, Visit visit) const;
    std::int64_t cellIndex(double offset, double cell) const;

    std::vector<Box> boxes_;
    Point origin_{0.0, 0.0};
    std::vector<Level> levels_;  // from fine to coarse
};

}  // namespace keyblock
