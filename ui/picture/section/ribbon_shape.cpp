// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/ribbon_shape.h"

#include "ui/picture/section/detail.h"

#include <algorithm>

namespace keyblock {

namespace {

/// The limit next to a force diagram as stepped lines, interrupted where there is no limit.
template <typename Ordinate>
std::vector<std::vector<Point>> limitLines(const Ribbon& ribbon, const Ordinate& ordinate) {
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

RibbonShape ribbonShape(const Ribbon& ribbon, const std::vector<double>& values, const std::vector<Point>& nodes,
                        double gap, double room) {
    RibbonShape shape;
    shape.across = turnLeft(alongOf(nodes));
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double sign = *high >= -*low ? 1.0 : -1.0;  // the larger values point away from the shank
    const double base = gap + std::max(0.0, sign > 0.0 ? -*low : *high) * room / ribbon.scale;
    const auto ordinate = [&](std::size_t node, double value) {
        return Point(nodes[node] + (base + sign * value * room / ribbon.scale) * shape.across);
    };
    for (std::size_t n = 0; n < nodes.size(); ++n) shape.base.push_back(ordinate(n, 0.0));
    shape.outline.push_back(shape.base.front());
    for (std::size_t e = 0; e < values.size(); ++e) {
        shape.outline.push_back(ordinate(e, values[e]));
        shape.outline.push_back(ordinate(e + 1, values[e]));
        shape.feet.push_back(0.5 * (shape.base[e] + shape.base[e + 1]));
        shape.tips.push_back(0.5 * (ordinate(e, values[e]) + ordinate(e + 1, values[e])));
    }
    shape.outline.push_back(shape.base.back());
    shape.peak = shape.tips[ribbon.peak];
    shape.limits = limitLines(ribbon, [&](std::size_t node, double value) { return ordinate(node, sign * value); });
    if (ribbon.limit) {
        shape.limitFrom = ordinate(0, sign * *ribbon.limit);
        shape.limitTo = ordinate(nodes.size() - 1, sign * *ribbon.limit);
    }
    return shape;
}

std::string ribbonUnit(const LegendBar& legend) { return legend.unit.substr(0, legend.unit.find(" per")); }

}  // namespace keyblock
