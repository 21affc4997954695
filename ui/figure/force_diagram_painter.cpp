// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The force diagram of a section: the values of one bolt, drawn next to the bolt
// together with their limit.
#include "ui/figure/map_painter.h"
#include "ui/picture/section/ribbon_shape.h"

#include <algorithm>

namespace keyblock {

using namespace paper_theme;

void MapPainter::drawRibbon(Ink& ink) {
    if (!picture_.ribbon) return;
    const Ribbon& ribbon = *picture_.ribbon;
    const BoltShape& bolt = picture_.bolts[ribbon.shape];
    const std::vector<Point> nodes = onPaper(bolt.nodes);
    const double room = std::min(12.0, 0.4 * scale_ * middleSpacing(picture_, ribbon.shape, 0.35 / scale_));
    if (room < 1.5) return;
    const RibbonShape shape = ribbonShape(ribbon, bolt.values, nodes, 1.1, room);
    const std::vector<Point>& outline = shape.outline;
    ink.polygon(outline, paper_theme::ribbon, {}, 0.16);
    ink.line(outline.front(), outline.back(), {0.13, paper_theme::ribbon});
    ink.polyline(outline, {0.2, paper_theme::ribbon});
    for (const std::vector<Point>& line : shape.limits) {
        ink.polyline(line, {0.2, error, {0.9, 0.45}});
        for (std::size_t i = 0; i + 1 < line.size(); ++i) placement_.keepOff(line[i], line[i + 1], 0.2);
    }
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) placement_.keepOff(outline[i], outline[i + 1], 0.2);
    for (std::size_t e = 0; e < shape.tips.size(); ++e)  // keeps labels off the filled area, too
        placement_.keepOff(shape.base[e], outline[2 * e + 1], 0.2);
    const std::string label = numberText(bolt.values[ribbon.peak]) + " " + ribbonUnit(*picture_.boltLegend);
    const Point size(textWidth(label, text_style::number) + 1.0, 3.0);
    if (const auto box = placement_.placeRound(size, shape.peak, shape.across)) {
        drawLeader(ink, shape.peak, *box);
        ink.casedText({box->min.x() + 0.5, box->max.y() - 0.8}, label, text_style::number);
    }
    ink.circle(shape.peak, 0.35, paper_theme::ribbon, {});
    if (ribbon.limit) drawLimitName(ink, ribbon, shape.limitFrom, shape.limitTo, shape.across);
}

/// Draws the name of the limit beyond one of its ends or next to it, where there is space. Otherwise the name is
/// omitted.
void MapPainter::drawLimitName(Ink& ink, const Ribbon& ribbon, const Point& from, const Point& to, const Point& across) {
    TextStyle style = text_style::tick;
    style.colour = error;
    const std::string name = ribbon.limitName + " " + numberText(*ribbon.limit) + " " +
                             ribbonUnit(*picture_.boltLegend);
    const Point size(textWidth(name, style) + 0.8, 2.6), along = (to - from).normalized();
    std::vector<Point> centres;
    const auto beside = [&](const Point& end, const Point& away) {
        centres.push_back(end + (0.6 + 0.5 * away.cwiseAbs().dot(size)) * away);
    };
    beside(from, -along);
    beside(to, along);
    for (const double share : {0.15, 0.85, 0.5, 0.3, 0.7}) beside(from + share * (to - from), across);
    if (const auto box = placement_.place(size, centres))
        ink.casedText({box->min.x() + 0.4, box->max.y() - 0.6}, name, style);
}

}  // namespace keyblock
