// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/chart.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace keyblock {

namespace {

constexpr double negligible = 1e-3;  // of the larger side of zero: a range does not open for it

/// Of the pieces of one limit on one side of zero, only the last is named.
void nameOnce(std::vector<ChartLimit>& limits) {
    for (auto limit = limits.begin(); limit != limits.end(); ++limit)
        if (std::any_of(std::next(limit), limits.end(), [&](const ChartLimit& later) {
                return later.name == limit->name && (later.value < 0.0) == (limit->value < 0.0);
            }))
            limit->name.clear();
}

}  // namespace

void fitRange(ChartPanel& panel) {
    ValueRange range = panel.reached;
    for (const ChartCurve& curve : panel.curves)
        for (const double y : curve.y)
            if (std::isfinite(y)) range = {std::min(range.low, y), std::max(range.high, y)};
    std::erase_if(panel.limits, [&](const ChartLimit& limit) {
        return limit.value >= 0.0 ? limit.value > limitReach * range.high : limit.value < limitReach * range.low;
    });
    nameOnce(panel.limits);
    for (const ChartLimit& limit : panel.limits)
        range = {std::min(range.low, limit.value), std::max(range.high, limit.value)};
    if (-range.low < negligible * range.high) range.low = 0.0;
    if (range.high < -negligible * range.low) range.high = 0.0;
    panel.range = roundedRange(range, mostPanelTicks);
}

}  // namespace keyblock
