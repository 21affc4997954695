// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Room for names, numbers and call-outs: each takes the first of its places where
// it covers nothing that was put down before. What finds no room is told so, and
// is left out or drawn over open ground by whoever asked.
#pragma once

#include "geometry/polygon.h"

#include <optional>
#include <vector>

namespace keyblock {

class Placement {
public:
    /// Everything stays within `frame`, in units of which `perMm` make what a millimetre is on paper.
    explicit Placement(const Box& frame, double perMm = 1.0) : frame_(frame), perMm_(perMm) {}

    void keepOff(const Box& box) { boxes_.push_back(box); }
    /// A line with `half` its width around it.
    void keepOff(const Point& a, const Point& b, double half) { lines_.push_back({a, b, half, false}); }
    /// The same for what leaders may cross: walls and outlines.
    void keepLabelsOff(const Point& a, const Point& b) { lines_.push_back({a, b, 0.2 * perMm_, true}); }

    bool isFree(const Box& box) const;

    /// Puts a box of `size` at the first of the centres where it is free, and keeps later ones off it.
    std::optional<Box> place(const Point& size, const std::vector<Point>& centres);

    /// The same for places round `at`, ever farther, beginning in direction `first`; leaders cross no line that is kept
    /// off, but near their foot.
    std::optional<Box> placeRound(const Point& size, const Point& at, const Point& first);

private:
    struct Line {
        Point a, b;
        double half;
        bool leadersCross;
    };
    bool leaderIsFree(const Point& at, const Point& to) const;

    Box frame_;
    double perMm_;
    std::vector<Box> boxes_;
    std::vector<Line> lines_;
};

/// The box of `size` about `centre`.
Box boxAbout(const Point& centre, const Point& size);

}  // namespace keyblock
