// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds positions for names, numbers and labels: each gets the first candidate position
// where it does not overlap anything placed before. If there is no such position, the
// caller omits the label or draws it over other objects.
#pragma once

#include "geometry/polygon.h"

#include <optional>
#include <vector>

namespace keyblock {

class Placement {
public:
    /// All labels are placed inside `frame`. \param perMm number of drawing units per millimetre on paper.
    explicit Placement(const Box& frame, double perMm = 1.0) : frame_(frame), perMm_(perMm) {}

    void keepOff(const Box& box) { boxes_.push_back(box); }
    /// Keeps labels and leaders off a line. \param half half the width of the line.
    void keepOff(const Point& a, const Point& b, double half) { lines_.push_back({a, b, half, false}); }
    /// Keeps labels off a line that leaders may cross, such as a wall or an outline.
    void keepLabelsOff(const Point& a, const Point& b) { lines_.push_back({a, b, 0.2 * perMm_, true}); }

    bool isFree(const Box& box) const;

    /// Places a box of the given size at the first of the candidate centres where it fits, and keeps later labels off
    /// the box. Null if the box fits at none of them.
    std::optional<Box> place(const Point& size, const std::vector<Point>& centres);

    /// Places a box near the point `at`, at the first free position. Positions are tried at increasing distances from
    /// the point; at each distance, all directions are tried, starting with `first`. Null if there is no free position
    /// nearby. The leader from the box to the point crosses no box or line given to `keepOff`, except near the point.
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

/// The box of the given size centred at `centre`.
Box boxAbout(const Point& centre, const Point& size);

}  // namespace keyblock
