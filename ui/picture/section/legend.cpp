// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/legend.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

/// Position of a colour step in the colour map. The first and the last step have the colours of its ends.
double shareOfStep(int step, int steps) { return steps > 1 ? static_cast<double>(step) / (steps - 1) : 0.5; }

}  // namespace

Colour LegendBar::colourOf(double shown, bool dark) const {
    const double share = shareOf(shown);
    if (scale.intervals <= 0) return colourAt(mapOn(dark), share);
    const double step = std::floor(share * scale.intervals);
    const double within = std::clamp(step, 0.0, scale.intervals - 1.0);
    return colourAt(mapOn(dark), shareOfStep(static_cast<int>(within), scale.intervals));
}

bool LegendBar::isDashed(double shown) const {
    constexpr double nothing = 1e-3;  // of the range
    return !dashed.empty() && shown < -nothing * std::max(std::abs(range.low), std::abs(range.high));
}

std::vector<std::pair<double, Colour>> LegendBar::stops(bool dark) const {
    const ColourMap& colours = mapOn(dark);
    std::vector<std::pair<double, Colour>> stops;
    for (std::size_t i = 0; scale.intervals <= 0 && i < colours.size(); ++i)
        stops.emplace_back(static_cast<double>(i) / static_cast<double>(colours.size() - 1), colours[i]);
    for (int step = 0; step < scale.intervals; ++step)
        for (const int end : {step, step + 1})
            stops.emplace_back(static_cast<double>(end) / scale.intervals,
                               colourAt(colours, shareOfStep(step, scale.intervals)));
    return stops;
}

}  // namespace keyblock
