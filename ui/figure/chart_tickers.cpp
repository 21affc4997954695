// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/chart_tickers.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double gap = 1.2;  // [mm] smallest gap between two times
constexpr int mostTried = 9;

}  // namespace

/// If there is space for one number only, shows the one farthest from zero, because zero alone would show no scale.
/// Zero is added if both fit.
Ticks RoundTicker::ticksIn(const ValueRange& range) const {
    const double least = least_ * (range.high - range.low);
    const auto touch = [&](const Ticks& t) { return t.values.size() > 1 && t.values[1] - t.values[0] < least; };
    Ticks round = roundTicks(range, most_);
    for (int most = most_ - 1; most > 1 && touch(round); --most) round = roundTicks(range, most);
    if (round.values.size() > 1 && !touch(round)) return round;
    for (int more = most_; more <= mostTried; ++more) {
        Ticks ticks = roundTicks(range, more);
        if (ticks.values.size() < 2) continue;
        const auto& values = ticks.values;
        const double far = std::abs(values.front()) > std::abs(values.back()) ? values.front() : values.back();
        const bool zero = std::find(values.begin(), values.end(), 0.0) != values.end() && std::abs(far) >= least;
        ticks.values = !zero ? std::vector{far} : far < 0.0 ? std::vector{far, 0.0} : std::vector{0.0, far};
        return ticks;
    }
    return round;
}

void RoundTicker::generate(const QCPRange& range, const QLocale&, QChar, int, QVector<double>& ticks,
                           QVector<double>* subTicks, QVector<QString>* labels) {
    const Ticks round = ticksIn({range.lower, range.upper});
    ticks = QVector<double>(round.values.begin(), round.values.end());
    if (subTicks) subTicks->clear();
    if (!labels) return;
    labels->clear();
    for (const double value : round.values) labels->append(QString::fromStdString(numberText(value, round.decimals)));
}

StageTicker::StageTicker(const Chart& chart, double length)
    : ticks_(stageTicks(chart.stages, length / (chart.x.high - chart.x.low),
                        [](const std::string& text) { return textWidth(text, text_style::tick) + gap; })) {}

void StageTicker::generate(const QCPRange&, const QLocale&, QChar, int, QVector<double>& ticks,
                           QVector<double>* subTicks, QVector<QString>* labels) {
    ticks.clear();
    if (subTicks) subTicks->clear();
    if (labels) labels->clear();
    for (const AxisTick& tick : ticks_) {
        ticks.append(tick.at);
        if (labels) labels->append(QString::fromStdString(tick.text));
    }
}

}  // namespace keyblock
