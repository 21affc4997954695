// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/trade_figure.h"

#include "solver/trade/trade_errors.h"
#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"
#include "ui/figure/trade_plot.h"

#include <qcustomplot.h>

#include <cmath>
#include <limits>

namespace keyblock {

namespace {

constexpr double tradePlotHeight = 97.0;  // [mm]

}  // namespace

TradeChart tradeChartOf(const Trade& trade) {
    const TradePoint& reference = trade.points[trade.reference];
    TradeChart chart;
    for (std::size_t i = 0; i < trade.points.size(); ++i) {
        const TradePoint& point = trade.points[i];
        const bool isReference = static_cast<int>(i) == trade.reference && i != 0;
        const bool onFront = !isReference && isOnFront(trade, i);
        const double error = isReference ? std::numeric_limits<double>::infinity()
                                         : largestError(point, reference, trade.quantities);
        chart.dots.push_back({point.seconds, error, point.axis, nameOf(point), onFront, onFront || i == 0});
    }
    return chart;
}

std::string paintTrade(const TradeChart& chart, PaperFormat format, double width) {
    if (!TradePlot::canShow(chart)) throw CannotDraw("no run of this trade has a result");
    const Sheet sheet(width, chart.title, chart.subtitle, {});
    const double height = std::ceil(sheet.heightAround(tradePlotHeight));
    Paper paper(format, width, height, 300, chart.title);
    Ink ink(paper.painter());
    sheet.draw(ink, height, chart.foot);
    const Box area{{paper_theme::margin, sheet.top()}, {width - paper_theme::margin, sheet.top() + tradePlotHeight}};
    TradePlot(chart, area).draw(ink);
    return paper.finish();
}

}  // namespace keyblock
