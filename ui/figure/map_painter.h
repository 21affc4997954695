// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws the section itself on paper: rock, walls, bolts, force diagram, names, numbers
// and the scale bar, inside a frame.
#pragma once

#include "ui/figure/ink.h"
#include "ui/picture/section/detail.h"
#include "ui/picture/section/placement.h"
#include "ui/picture/section/section.h"

#include <vector>

namespace keyblock {

class MapPainter {
public:
    /// Prepares to draw the section in `frame` [mm]. The visible part of the section is extended to the aspect ratio of
    /// the frame.
    MapPainter(const SectionPicture& picture, const Box& frame);

    /// The kinds of marks that will be drawn, each once, in the order of the key.
    std::vector<MarkKind> kinds() const { return kindsOf(marks_); }

    /// Length on paper of the longest contact line [mm]; 0 if no contact forces are shown.
    double longestContact() const;

    void draw(Ink& ink);

private:
    Point onPaper(const Point& p) const;
    std::vector<Point> onPaper(const std::vector<Point>& points) const;
    void drawLines(Ink& ink, const std::vector<LineShape>& lines, const Stroke& stroke) const;
    void drawBlock(Ink& ink, const BlockShape& block, const Stroke& outline) const;
    void drawBlocks(Ink& ink) const;
    void drawShank(Ink& ink, std::size_t index) const;
    void drawMarks(Ink& ink, std::size_t index) const;
    void drawArrows(Ink& ink) const;
    void drawContacts(Ink& ink) const;
    void drawRibbon(Ink& ink);
    /// Draws the name of the limit beyond one end of the limit line or next to the line; omits the name if there is no
    /// space.
    void drawLimitName(Ink& ink, const Ribbon& ribbon, const Point& from, const Point& to, const Point& across);
    void drawScaleBar(Ink& ink);
    void drawNumbers(Ink& ink);
    void drawNames(Ink& ink);
    void drawMoved(Ink& ink);
    Point footWithin(const std::vector<Point>& outline) const;
    void drawLeader(Ink& ink, const Point& from, const Box& label) const;

    const SectionPicture& picture_;
    Box frame_;  // [mm]
    Box window_;  // [m]
    double scale_ = 1.0;  // mm per m
    std::vector<double> spacing_;  // distance of each bolt from the nearest other one [mm]
    std::vector<std::vector<Mark>> marks_;  // of each bolt, thinned out
    Placement placement_;
};

}  // namespace keyblock
