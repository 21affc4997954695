// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/film_line.h"

#include "solver/results/result_names.h"
#include "ui/figure/mark_painter.h"

#include <algorithm>
#include <tuple>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double numbersRoom = 4.0, filmBandHeight = 1.6, radius = 1.35;  // [mm]
constexpr double namesBelow = numbersRoom + filmBandHeight + 2.7;  // [mm]

}  // namespace

FilmLine::FilmLine(const RunSource& run, const std::vector<std::size_t>& frames, const EventList& events)
    : count_(frames.size()) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const int stage = run.frames()[frames[i]].stage;
        if (i == 0 || run.frames()[frames[i - 1]].stage != stage)
            parts_.push_back({stageName(run.scene(), stage), i, i});
        parts_.back().end = i + 1;
    }
    for (const EventEntry& entry : events.entries)
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const FrameHead& head = run.frames()[frames[i]];
            if (std::tie(head.stage, head.time) < std::tie(entry.stage, entry.time)) continue;
            marks_.push_back({entry.number, i});
            break;
        }
}

double FilmLine::placeOf(std::size_t picture, double width) const {
    return width * static_cast<double>(picture) / static_cast<double>(count_);
}

/// Draws the numbers of events above the band, once the events have occurred. A number that would overlap the one
/// before it is omitted, but its tick stays.
void FilmLine::drawMarks(Ink& ink, const Point& at, double width, std::size_t now) const {
    double free = -radius;
    for (const Mark& mark : marks_) {
        if (mark.picture > now) continue;
        const double x = placeOf(mark.picture, width);
        ink.line(at + Point(x, numbersRoom - 1.1), at + Point(x, numbersRoom + filmBandHeight), {0.25, black});
        const double centre = std::clamp(x, radius, width - radius);
        if (centre - radius < free) continue;
        drawNumber(ink, at + Point(centre, radius + 0.1), mark.number, radius, {1.8, true});
        free = centre + radius + 0.3;
    }
}

void FilmLine::draw(Ink& ink, const Point& at, double width, std::size_t picture) const {
    const Point top = at + Point(0.0, numbersRoom), bottom = top + Point(0.0, filmBandHeight);
    const double done = placeOf(picture + 1, width);
    ink.box({top, bottom + Point(width, 0.0)}, grid, {});
    ink.box({top, bottom + Point(done, 0.0)}, softText, {});
    for (const Part& part : parts_) {
        const double from = placeOf(part.first, width), to = placeOf(part.end, width);
        ink.box({top + Point(from, 0.0), bottom + Point(to, 0.0)}, {}, Stroke{0.13, black});
        const bool now = part.first <= picture && picture < part.end;
        const TextStyle style{2.0, now, now ? black : softText};
        const std::string name = elided(part.name, style, to - from - 0.6);
        if (name == part.name || name.size() > 7)  // more than four letters and the three bytes of the ellipsis
            ink.text(at + Point(0.5 * (from + to), namesBelow), name, style, Align::Centre);
    }
    drawMarks(ink, at, width, picture);
}

}  // namespace keyblock
