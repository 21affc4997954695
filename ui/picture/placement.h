// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions for names, numbers and labels: each gets the first candidate position where
// it overlaps nothing placed before. If there is none, the caller omits it or draws it
// over other objects.
#pragma once

#include "geometry/polygon.h"

#include <optional>
#include <vector>

namespace keyblock {

class Placement {
public:
    /// Everything stays within `frame`, in units of which `perMm` are one millimetre on paper.
    explicit Placement(const Box& frame, double perMm = 1.0) : frame_(frame), perMm_(perMm) {}

    void keepOff(const Box& box) { boxes_.push_back(box); }
    /// A line with `half` its width around it.
    void keepOff(const Point& a, const Point& b, double half) { lines_.push_back({a, b, half, false}); }
    /// The same for lines that leaders may cross: walls and outlines.
    void keepLabelsOff(const Point& a, const Point& b) { lines_.push_back({a, b, 0.2 * perMm_, true}); }

    bool isFree(const Box& box) const;

    /// Places a box of `size` at the first free centre, and keeps later boxes off it.
    std::optional<Box> place(const Point& size, const std::vector<Point>& centres);

    /// The same for positions around `at`, with growing distance, starting in direction `first`; leaders cross no line
    /// that is kept off, except near their foot.
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
