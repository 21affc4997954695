// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/chart_tickers.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

QVector<QString> labelsOf(RoundTicker& ticker, double low, double high) {
    QVector<double> ticks;
    QVector<QString> labels;
    ticker.generate({low, high}, QLocale::c(), 'g', 6, ticks, nullptr, &labels);
    EXPECT_EQ(ticks.size(), labels.size());
    return labels;
}

TEST(ChartTickers, NumbersOfALowPanelDoNotOverlapAndShowTheScale) {
    RoundTicker ticker(5);
    EXPECT_EQ(labelsOf(ticker, 0.0, 200.0), (QVector<QString>{"0", "50", "100", "150", "200"}));
    ticker.setLeast(0.4);
    EXPECT_EQ(labelsOf(ticker, 0.0, 200.0), (QVector<QString>{"0", "100", "200"}));
    ticker.setLeast(0.8);
    EXPECT_EQ(labelsOf(ticker, 0.0, 200.0), (QVector<QString>{"0", "200"}));
    EXPECT_EQ(labelsOf(ticker, -0.0003, 0.0), (QVector<QString>{QString::fromUtf8("−0.0003"), "0.0000"}));
    RoundTicker low(2);
    low.setLeast(0.3);
    EXPECT_EQ(labelsOf(low, -0.03, 0.04), (QVector<QString>{"0.000", "0.025"}));  // not zero only
    low.setLeast(0.5);
    EXPECT_EQ(labelsOf(low, -0.03, 0.04), QVector<QString>{"0.025"});
}

}  // namespace
}  // namespace keyblock
