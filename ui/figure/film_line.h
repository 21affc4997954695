// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The timeline below each image of an animation: the stages one after another, the
// numbered events at their times, and the progress of the animation. Each image takes
// up the same length, as it is shown for the same time.
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
    /// \param frames for each image, in order, the index in the run of the frame that it shows.
    /// \param events the numbered events of the last of these frames.
    FilmLine(const RunSource& run, const std::vector<std::size_t>& frames, const EventList& events);

    /// Draws the timeline below the image with the index `picture`. The timeline is `width` [mm] wide and has its upper
    /// left corner at `at` [mm].
    void draw(Ink& ink, const Point& at, double width, std::size_t picture) const;

private:
    struct Part {
        std::string name;  // of the stage
        std::size_t first = 0, end = 0;  // index of its first image, and of the first image after it
    };
    struct Mark {
        int number = 0;
        std::size_t picture = 0;  // first image that shows the event
    };

    double placeOf(std::size_t picture, double width) const;
    void drawMarks(Ink& ink, const Point& at, double width, std::size_t now) const;

    std::size_t count_;
    std::vector<Part> parts_;
    std::vector<Mark> marks_;
};

}  // namespace keyblock
