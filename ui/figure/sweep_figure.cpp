// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/sweep_figure.h"

#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"
#include "ui/picture/ticks.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double plotHeight = 62.0, plotAbove = 5.0, plotBelow = 10.0, plotLeft = 13.0, plotRight = 11.0;  // [mm]
constexpr int mostTicks = 7;
constexpr Colour bars = rgb(0x7F84C8), curve = rgb(0xC2410C), marked = error, band = rgb(0xD5D7EE);

/// The range of some values, rounded to ticks; wider than nothing.
ValueRange rangeOf(double low, double high) {
    if (!(low < high)) {
        const double half = low == 0.0 ? 1.0 : 0.05 * std::abs(low);
        low -= half;
        high += half;
    }
    return roundedRange({low, high}, mostTicks);
}

/// A plot with linear axes on a sheet.
class Plot {
public:
    Plot(const Sheet& sheet, const ValueRange& x, const ValueRange& y)
        : x_(x), y_(y), left_(margin + plotLeft), right_(sheet.width() - margin - plotRight),
          top_(sheet.top() + plotAbove), bottom_(top_ + plotHeight) {}

    double atX(double value) const { return left_ + (value - x_.low) / (x_.high - x_.low) * (right_ - left_); }
    double atY(double value) const { return bottom_ - (value - y_.low) / (y_.high - y_.low) * (bottom_ - top_); }
    Point at(double x, double y) const { return {atX(x), atY(y)}; }
    double right() const { return right_; }
    double top() const { return top_; }
    double bottom() const { return bottom_; }

    void drawAxes(Ink& ink, const std::string& xTitle, const std::string& yTitle) const {
        const Ticks xTicks = roundTicks(x_, mostTicks), yTicks = roundTicks(y_, mostTicks);
        for (const double value : xTicks.values) {
            ink.line({atX(value), bottom_}, {atX(value), top_}, {0.13, grid});
            ink.text({atX(value), bottom_ + 3.0}, numberText(value, xTicks.decimals), text_style::tick, Align::Centre);
        }
        for (const double value : yTicks.values) {
            ink.line({left_, atY(value)}, {right_, atY(value)}, {0.13, grid});
            ink.text({left_ - 1.0, atY(value) + 0.7}, numberText(value, yTicks.decimals), text_style::tick,
                     Align::Right);
        }
        ink.line({left_, bottom_}, {right_, bottom_}, {0.15, axis});
        ink.line({left_, bottom_}, {left_, top_}, {0.15, axis});
        const std::string title = elided(xTitle, text_style::body, right_ - left_, true);
        ink.text({0.5 * (left_ + right_), bottom_ + 7.2}, title, text_style::body, Align::Centre);
        ink.text({margin, top_ - 1.6}, elided(yTitle, text_style::body, right_ - left_, true), text_style::body);
    }

private:
    ValueRange x_, y_;
    double left_, right_, top_, bottom_;
};

constexpr const char* sweepFoot = "Keyblock · keyblock sweep";

/// Draws a plot on paper: sheet, then what `draw` adds.
template <typename Draw>
std::string onPaper(const std::string& title, const std::string& subtitle, PaperFormat format, double width,
                    double height, Draw draw) {
    const Sheet sheet(width, title, subtitle, {});
    const double whole = std::ceil(sheet.heightAround(height));
    Paper paper(format, width, whole, 300, title);
    Ink ink(paper.painter());
    sheet.draw(ink, whole, sweepFoot);
    draw(ink, sheet);
    return paper.finish();
}

constexpr double wholeHeight = plotAbove + plotHeight + plotBelow;

/// Number of bars of a histogram (Freedman and Diaconis 1981), within reason.
int barsFor(const std::vector<double>& sorted) {
    const auto quantile = [&](double share) {
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    const double spread = quantile(0.75) - quantile(0.25);
    const double width = 2.0 * spread / std::cbrt(static_cast<double>(sorted.size()));
    const double count = width > 0.0 ? std::ceil((sorted.back() - sorted.front()) / width) : 10.0;
    return static_cast<int>(std::clamp(count, 1.0, 60.0));
}

std::vector<double> countsOf(const std::vector<double>& sorted, int count) {
    std::vector<double> counts(count, 0.0);
    const double low = sorted.front(), width = sorted.back() - low;
    for (const double value : sorted) {
        const int bar = width > 0.0 ? static_cast<int>((value - low) / width * count) : 0;
        counts[std::clamp(bar, 0, count - 1)] += 1.0;
    }
    return counts;
}

/// The cumulative curve, at no more than 400 points.
std::vector<Point> cumulative(const std::vector<double>& sorted, const Plot& plot, double scale) {
    std::vector<Point> points;
    const std::size_t every = std::max<std::size_t>(1, sorted.size() / 400);
    for (std::size_t i = 0; i < sorted.size(); ++i)
        if (i % every == 0 || i + 1 == sorted.size())
            points.push_back(
                plot.at(sorted[i], scale * static_cast<double>(i + 1) / static_cast<double>(sorted.size())));
    return points;
}

}  // namespace

std::string paintHistogram(const HistogramChart& chart, PaperFormat format, double width) {
    if (chart.sorted.empty()) throw CannotDraw("there are no values");
    return onPaper(chart.title, chart.subtitle, format, width, wholeHeight, [&](Ink& ink, const Sheet& sheet) {
        const int count = barsFor(chart.sorted);
        const std::vector<double> counts = countsOf(chart.sorted, count);
        const double low = chart.sorted.front(), wide = (chart.sorted.back() - low) / count;
        const ValueRange y = rangeOf(0.0, *std::ranges::max_element(counts));
        const Plot plot(sheet, rangeOf(low, chart.sorted.back()), y);
        plot.drawAxes(ink, chart.axis, "Cases");
        for (int i = 0; i < count; ++i)
            if (counts[i] > 0.0)
                ink.box({{plot.atX(low + i * wide), plot.atY(counts[i])},
                         {std::max(plot.atX(low + (i + 1) * wide), plot.atX(low + i * wide) + 0.4), plot.bottom()}},
                        bars, Stroke{0.1, white});
        ink.polyline(cumulative(chart.sorted, plot, y.high), {0.3, curve});
        for (const int percent : {0, 50, 100})
            ink.text({plot.right() + 1.0, plot.atY(y.high * percent / 100.0) + 0.7}, std::to_string(percent) + " %",
                     {2.0, false, curve});
        ink.text({plot.right() + plotRight, plot.top() - 1.6}, "cumulative", {2.0, false, curve}, Align::Right);
    });
}

std::string paintScatter(const ScatterChart& chart, PaperFormat format, double width) {
    if (chart.dots.empty()) throw CannotDraw("no case has both values");
    const auto [left, right] = std::ranges::minmax(chart.dots, {}, &ScatterDot::x);
    const auto [low, high] = std::ranges::minmax(chart.dots, {}, &ScatterDot::y);
    return onPaper(chart.title, chart.subtitle, format, width, wholeHeight, [&](Ink& ink, const Sheet& sheet) {
        const Plot plot(sheet, rangeOf(left.x, right.x), rangeOf(low.y, high.y));
        plot.drawAxes(ink, chart.xAxis, chart.yAxis);
        const double radius = chart.dots.size() > 2000 ? 0.25 : 0.45;
        for (const bool isMarked : {false, true})
            for (const ScatterDot& d : chart.dots)
                if (d.isMarked == isMarked)
                    ink.circle(plot.at(d.x, d.y), radius, isMarked ? marked : ribbon, std::nullopt);
        const bool any = std::ranges::any_of(chart.dots, &ScatterDot::isMarked);
        if (any) ink.text({plot.right(), plot.top() - 1.6}, "red: the case fails", {2.0, false, marked}, Align::Right);
    });
}

std::string paintTornado(const TornadoChart& chart, PaperFormat format, double width) {
    if (chart.bars.empty()) throw CannotDraw("nothing varies");
    constexpr double rowHeight = 5.0, nameRoom = 34.0;
    constexpr std::size_t mostBars = 30;
    const std::size_t count = std::min(chart.bars.size(), mostBars);
    const double height = plotAbove + rowHeight * static_cast<double>(count) + plotBelow;
    return onPaper(chart.title, chart.subtitle, format, width, height, [&](Ink& ink, const Sheet& sheet) {
        const double left = margin + nameRoom, right = sheet.width() - margin - 8.0, top = sheet.top() + plotAbove;
        const double bottom = top + rowHeight * static_cast<double>(count), middle = 0.5 * (left + right);
        const auto at = [&](double value) { return middle + value * 0.5 * (right - left); };
        for (const double value : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            ink.line({at(value), bottom}, {at(value), top}, {0.13, value == 0.0 ? axis : grid});
            ink.text({at(value), bottom + 3.0}, numberText(value, 1), text_style::tick, Align::Centre);
        }
        ink.text({middle, bottom + 7.2}, "Rank correlation", text_style::body, Align::Centre);
        for (std::size_t i = 0; i < count; ++i) {
            const TornadoBar& bar = chart.bars[i];
            const double y = top + rowHeight * (static_cast<double>(i) + 0.5), end = at(bar.value);
            ink.box({{std::min(middle, end), y - 1.5}, {std::max(middle, end), y + 1.5}},
                    bar.value < 0.0 ? curve : bars, std::nullopt);
            ink.text({left - 1.5, y + 0.7}, elided(bar.name, text_style::body, nameRoom - 2.0, true), text_style::body,
                     Align::Right);
            ink.casedText({end + (bar.value < 0.0 ? -1.0 : 1.0), y + 0.7}, numberText(bar.value, 2), text_style::tick,
                          bar.value < 0.0 ? Align::Right : Align::Left);
        }
    });
}

std::string paintConvergence(const ConvergenceChart& chart, PaperFormat format, double width) {
    if (chart.points.empty()) throw CannotDraw("no case is decided");
    const std::size_t settled = std::min<std::size_t>(chart.points.size() - 1, chart.points.size() / 20);
    double high = 0.0;  // the first few intervals are much wider than the rest
    for (std::size_t i = settled; i < chart.points.size(); ++i) high = std::max(high, chart.points[i].high);
    return onPaper(chart.title, chart.subtitle, format, width, wholeHeight, [&](Ink& ink, const Sheet& sheet) {
        const ValueRange y = rangeOf(0.0, std::min(1.0, high));
        const Plot plot(sheet, rangeOf(0.0, chart.points.back().cases), y);
        plot.drawAxes(ink, "Cases", "Probability of failure");
        std::vector<Point> outline, line;
        const auto inside = [&](double value) { return std::min(value, y.high); };
        for (const ChancePoint& p : chart.points) outline.push_back(plot.at(p.cases, inside(p.low)));
        for (auto p = chart.points.rbegin(); p != chart.points.rend(); ++p)
            outline.push_back(plot.at(p->cases, inside(p->high)));
        for (const ChancePoint& p : chart.points) line.push_back(plot.at(p.cases, inside(p.probability)));
        ink.polygon(outline, band, std::nullopt);
        ink.polyline(line, {0.3, ribbon});
        const ChancePoint& last = chart.points.back();
        ink.casedText({plot.right(), plot.atY(inside(last.high)) - 1.2}, numberText(last.probability),
                      text_style::number, Align::Right);
    });
}

}  // namespace keyblock
