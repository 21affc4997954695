// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The line below each picture of an animation: its stages one after another, the
// numbered events at their times, and the progress of the animation. Each picture takes
// the same length, as it takes the same time on the screen.
#pragma once

#include "solver/results/run_source.h"
#include "ui/figure/ink.h"
#include "ui/picture/event_list.h"

#include <string>
#include <vector>

namespace keyblock {

inline constexpr double filmLineHeight = 9.0;  // [mm]

class FilmLine {
public:
    /// Of these frames of the run, in order, with the events that are numbered in the last one.
    FilmLine(const RunSource& run, const std::vector<std::size_t>& frames, const EventList& events);

    /// Drawn from the upper left corner `at` over `width` [mm], for one of the pictures.
    void draw(Ink& ink, const Point& at, double width, std::size_t picture) const;

private:
    struct Part {
        std::string name;  // of the stage
        std::size_t first = 0, end = 0;  // number of pictures
    };
    struct Mark {
        int number = 0;
        std::size_t picture = 0;  // the first that shows it
    };

    double placeOf(std::size_t picture, double width) const;
    void drawMarks(Ink& ink, const Point& at, double width, std::size_t now) const;

    std::size_t count_;
    std::vector<Part> parts_;
    std::vector<Mark> marks_;
};

}  // namespace keyblock
