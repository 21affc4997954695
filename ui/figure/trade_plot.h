// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chart of a trade within an area of a sheet or of the window: axes, front, dots,
// their names, and a key of the colours.
#pragma once

#include "ui/figure/chart_painter.h"
#include "ui/figure/trade_figure.h"

#include <cstddef>
#include <string>
#include <vector>

namespace keyblock {

/// A logarithmic axis over whole decades, or parts of one.
class LogAxis {
public:
    /// Values from `low` to `high`, drawn between the positions `from` and `to` [mm].
    LogAxis(double low, double high, double from, double to);

    double at(double value) const;  // position [mm]
    /// 1, 2 and 5 times the powers of ten in the range; only the powers if there are many.
    std::vector<double> ticks() const;

private:
    double low_, high_, from_, to_;
};

/// Colour of the dots of one kind of setting, from 0; they repeat after ten.
Colour tradeColour(std::size_t number, const Colour& ground);

class TradePlot {
public:
    /// \param area [mm, y downwards]. If it is narrow, the key is left out. \pre a dot of the chart has a finite error.
    TradePlot(TradeChart chart, const Box& area, const ChartTheme& theme = paperChartTheme());

    /// Whether a dot of the chart has a finite error.
    static bool canShow(const TradeChart& chart);

    void draw(Ink& ink);

    /// Index of the dot nearest to a position [mm], at most `reach` [mm] away; −1: there is none.
    int dotAt(const Point& place, double reach) const;
    Point placeOf(const TradeDot& dot) const;

private:
    LogAxis timeAxis() const;
    LogAxis errorAxis();
    Colour colourOf(const std::string& axis) const;
    TextStyle inked(TextStyle style) const;
    void drawAxes(Ink& ink) const;
    void drawFront(Ink& ink) const;
    void drawDot(Ink& ink, const TradeDot& dot) const;
    void drawName(Ink& ink, const TradeDot& dot);
    void drawKey(Ink& ink) const;

    TradeChart chart_;
    ChartTheme theme_;
    double keyRoom_, left_, right_, top_, bottom_;
    double floor_;  // error at the lower edge, where errors of 0 are drawn
    LogAxis time_, error_;
    std::vector<std::string> axes_;
    std::vector<Box> taken_;  // by dots and names
};

}  // namespace keyblock
