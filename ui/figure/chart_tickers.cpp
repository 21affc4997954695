// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/chart_tickers.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double gap = 1.2;  // between two times [mm]

}  // namespace

void RoundTicker::generate(const QCPRange& range, const QLocale&, QChar, int, QVector<double>& ticks,
                           QVector<double>* subTicks, QVector<QString>* labels) {
    Ticks round = roundTicks({range.lower, range.upper}, most_);
    const auto touch = [&] {
        return round.values.size() > 1 && round.values[1] - round.values[0] < least_ * (range.upper - range.lower);
    };
    for (int most = most_ - 1; most > 1 && touch(); --most) round = roundTicks({range.lower, range.upper}, most);
    if (touch())
        round.values = {*std::max_element(round.values.begin(), round.values.end(),
                                          [](double a, double b) { return std::abs(a) < std::abs(b); })};
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
