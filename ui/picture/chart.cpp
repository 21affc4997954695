// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/chart.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>

namespace keyblock {

namespace {

constexpr double negligibleSide = 1e-3;  // relative to the other side of zero; a smaller side of a range is omitted

/// If a limit has several pieces on one side of zero, only the last piece is named.
void nameOnce(std::vector<ChartLimit>& limits) {
    for (auto limit = limits.begin(); limit != limits.end(); ++limit)
        if (std::any_of(std::next(limit), limits.end(), [&](const ChartLimit& later) {
                return later.name == limit->name && (later.value < 0.0) == (limit->value < 0.0);
            }))
            limit->name.clear();
}

constexpr int mostStageTicks = 8;

using WidthOf = std::function<double(const std::string&)>;

/// Ticks of one stage with at most `most` numbers. Numbers that would extend beyond `end`, where the numbers of the
/// next stage begin, are omitted. The result is empty if numbers would overlap.
std::vector<AxisTick> ticksWithin(const StageSpan& span, int most, double end, double perUnit, const WidthOf& widthOf) {
    const Ticks round = roundTicks({0.0, span.reached}, most);
    std::vector<AxisTick> ticks;
    double free = 0.0;
    for (const double value : round.values) {
        const AxisTick tick{span.from + (span.to - span.from) * value / span.reached,
                            numberText(value, value == 0.0 ? 0 : round.decimals)};
        const double place = tick.at * perUnit, half = 0.5 * widthOf(tick.text);
        if (place + half > end) break;
        if (!ticks.empty() && place - half < free) return {};
        free = place + half;
        ticks.push_back(tick);
    }
    return ticks;
}

}  // namespace

std::vector<AxisTick> stageTicks(const std::vector<StageSpan>& stages, double perUnit, const WidthOf& widthOf) {
    std::vector<AxisTick> all;
    double end = std::numeric_limits<double>::infinity();
    for (auto span = stages.rbegin(); span != stages.rend(); ++span) {
        if (!(span->reached > 0.0)) continue;
        std::vector<AxisTick> ticks;
        for (int most = mostStageTicks; most > 1 && ticks.empty(); --most)
            ticks = ticksWithin(*span, most, end, perUnit, widthOf);
        if (ticks.empty() && span->from * perUnit + 0.5 * widthOf("0") <= end) ticks.push_back({span->from, "0"});
        all.insert(all.begin(), ticks.begin(), ticks.end());
        if (!ticks.empty()) end = ticks.front().at * perUnit - 0.5 * widthOf(ticks.front().text);
    }
    return all;
}

StageMoment momentAt(const std::vector<StageSpan>& stages, double place) {
    assert(!stages.empty());
    const auto found = std::find_if(stages.begin(), stages.end(), [&](const StageSpan& s) { return place <= s.to; });
    const StageSpan& span = found == stages.end() ? stages.back() : *found;
    const double room = span.to - span.from;
    return {&span, room > 0.0 ? span.reached * std::clamp((place - span.from) / room, 0.0, 1.0) : 0.0};
}

void fitRange(ChartPanel& panel) {
    ValueRange range = canBeShown(panel.reached.low) && canBeShown(panel.reached.high) ? panel.reached : ValueRange{};
    for (const ChartCurve& curve : panel.curves)
        for (const double y : curve.y)
            if (canBeShown(y)) range = {std::min(range.low, y), std::max(range.high, y)};
    std::erase_if(panel.limits, [&](const ChartLimit& limit) {
        if (!canBeShown(limit.value)) return true;
        return limit.value >= 0.0 ? limit.value > limitReach * range.high : limit.value < limitReach * range.low;
    });
    nameOnce(panel.limits);
    for (const ChartLimit& limit : panel.limits)
        range = {std::min(range.low, limit.value), std::max(range.high, limit.value)};
    if (-range.low < negligibleSide * range.high) range.low = 0.0;
    if (range.high < -negligibleSide * range.low) range.high = 0.0;
    panel.range = roundedRange(range, mostPanelTicks);
}

ChartCurve thinned(const ChartCurve& curve, std::size_t most) {
    const std::size_t count = curve.y.size(), runs = std::max<std::size_t>(1, most / 4);
    if (count <= most) return curve;
    ChartCurve kept = curve;
    kept.x.clear();
    kept.y.clear();
    for (std::size_t r = 0; r < runs; ++r) {
        const std::size_t first = r * count / runs, end = (r + 1) * count / runs;
        const auto [low, high] = std::minmax_element(curve.y.begin() + static_cast<long>(first),
                                                     curve.y.begin() + static_cast<long>(end));
        std::array<std::size_t, 4> chosen{first, static_cast<std::size_t>(low - curve.y.begin()),
                                          static_cast<std::size_t>(high - curve.y.begin()), end - 1};
        std::sort(chosen.begin(), chosen.end());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (i > 0 && chosen[i] == chosen[i - 1]) continue;
            kept.x.push_back(curve.x[chosen[i]]);
            kept.y.push_back(curve.y[chosen[i]]);
        }
    }
    return kept;
}

}  // namespace keyblock
