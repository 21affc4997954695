// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The ribbon of a section: the values of one bolt drawn beside it, with the limit
// that they meet.
#include "ui/figure/map_ink.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

/// The limit beside a ribbon as lines of steps, an interruption where there is none.
template <typename Ordinate>
std::vector<std::vector<Point>> ribbonLimits(const Ribbon& ribbon, const Ordinate& ordinate) {
    std::vector<std::vector<Point>> lines;
    for (std::size_t e = 0; e < ribbon.limits.size(); ++e) {
        const double limit = ribbon.limits[e];
        if (limit <= 0.0) continue;
        if (e == 0 || ribbon.limits[e - 1] <= 0.0) lines.emplace_back();
        if (lines.back().size() > 1 && ribbon.limits[e - 1] == limit) lines.back().pop_back();
        else lines.back().push_back(ordinate(e, limit));
        lines.back().push_back(ordinate(e + 1, limit));
    }
    return lines;
}

}  // namespace

void MapInk::drawRibbon(Ink& ink) {
    if (!picture_.ribbon) return;
    const Ribbon& ribbon = *picture_.ribbon;
    const BoltShape& bolt = picture_.bolts[ribbon.shape];
    const std::vector<Point> nodes = onPaper(bolt.nodes);
    const double largest = ribbon.scale;
    const double room = ribbonRoom(bolt);
    if (room < 1.5) return;
    const Point along = alongOf(nodes), across = turnLeft(along);
    const auto [low, high] = std::minmax_element(bolt.values.begin(), bolt.values.end());
    const double sign = *high >= -*low ? 1.0 : -1.0;  // the larger side looks away from the shank
    const double base = 1.1 + std::max(0.0, sign > 0.0 ? -*low : *high) * room / largest;
    const auto ordinate = [&](std::size_t node, double value) {
        return Point(nodes[node] + (base + sign * value * room / largest) * across);
    };
    std::vector<Point> outline{nodes.front() + base * across}, curve;
    for (std::size_t e = 0; e < bolt.values.size(); ++e) {
        curve.push_back(ordinate(e, bolt.values[e]));
        curve.push_back(ordinate(e + 1, bolt.values[e]));
    }
    outline.insert(outline.end(), curve.begin(), curve.end());
    outline.push_back(nodes.back() + base * across);
    ink.polygon(outline, paper_theme::ribbon, {}, 0.16);
    ink.line(outline.front(), outline.back(), {0.13, paper_theme::ribbon});
    ink.polyline(outline, {0.2, paper_theme::ribbon});
    const auto limits =
        ribbonLimits(ribbon, [&](std::size_t node, double value) { return ordinate(node, sign * value); });
    for (const std::vector<Point>& line : limits) {
        ink.polyline(line, {0.2, error, {0.9, 0.45}});
        for (std::size_t i = 0; i + 1 < line.size(); ++i) placement_.keepOff(line[i], line[i + 1], 0.2);
    }
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) placement_.keepOff(outline[i], outline[i + 1], 0.2);
    for (std::size_t e = 0; e < bolt.values.size(); ++e)  // nor on its fill
        placement_.keepOff(nodes[e] + base * across, ordinate(e, bolt.values[e]), 0.2);
    const Point peak = 0.5 * (ordinate(ribbon.peak, bolt.values[ribbon.peak]) +
                              ordinate(ribbon.peak + 1, bolt.values[ribbon.peak]));
    const std::string label = numberText(bolt.values[ribbon.peak]) + " " + picture_.boltLegend->unit.substr(
                                  0, picture_.boltLegend->unit.find(" per"));
    const Point size(textWidth(label, text_style::number) + 1.0, 3.0);
    if (const auto box = placement_.placeRound(size, peak, across)) {
        drawLeader(ink, peak, *box);
        ink.casedText({box->min.x() + 0.5, box->max.y() - 0.8}, label, text_style::number);
    }
    ink.circle(peak, 0.35, paper_theme::ribbon, {});
    if (ribbon.limit)
        drawLimitName(ink, ribbon, ordinate(0, sign * *ribbon.limit), ordinate(nodes.size() - 1, sign * *ribbon.limit),
                      across);
}

/// At an end of the limit or beyond it, where there is room; else nowhere.
void MapInk::drawLimitName(Ink& ink, const Ribbon& ribbon, const Point& from, const Point& to, const Point& across) {
    TextStyle style = text_style::tick;
    style.colour = error;
    const std::string name = ribbon.limitName + " " + numberText(*ribbon.limit) + " " +
                             picture_.boltLegend->unit.substr(0, picture_.boltLegend->unit.find(" per"));
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
