// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chart of accuracy against time: one dot for each run, both axes logarithmic, with the
// front of those runs that no other run beats in both.
#pragma once

#include "solver/trade/trade.h"
#include "ui/figure/figure.h"

#include <string>
#include <vector>

namespace keyblock {

/// One run in the chart.
struct TradeDot {
    double seconds = 0.0;
    double error = 0.0;  // a share, as in 0.03; 0: drawn at the lower edge; infinite: not drawn
    std::string axis, name;  // dots of one axis have one colour
    bool onFront = false;
    bool isNamed = false;  // the name is written beside the dot
};

struct TradeChart {
    std::string title, subtitle, foot;
    std::vector<TradeDot> dots;
};

/// A dot for each point of a trade, in the same order, without titles. That of the reference has no error and is not
/// drawn, unless it is the scene's own. \pre the trade has a point.
TradeChart tradeChartOf(const Trade& trade);

/// Draws the chart on a sheet of this width [mm]. \return the contents of the file.
/// \throws CannotDraw if no dot has a finite error.
std::string paintTrade(const TradeChart& chart, PaperFormat format, double width = 160.0);

}  // namespace keyblock
