// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/sweep_plot.h"

#include "ui/picture/ticks.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double plotAbove = 5.0, plotBelow = 10.0, plotLeft = 13.0, plotRight = 11.0;  // [mm]
constexpr double barRow = 5.0, barNameRoom = 34.0, barEndRoom = 8.0;  // [mm] of tornados
constexpr std::size_t mostBars = 30;
constexpr int mostTicks = 7;

/// The range of some values, rounded to ticks; wider than nothing.
ValueRange sweepRange(double low, double high) {
    if (!(low < high)) {
        const double half = low == 0.0 ? 1.0 : 0.05 * std::abs(low);
        low -= half;
        high += half;
    }
    return roundedRange({low, high}, mostTicks);
}

TextStyle inInk(TextStyle style, const Colour& colour) {
    style.colour = colour;
    return style;
}

/// A plot with linear axes in an area.
class LinearPlot {
public:
    LinearPlot(const Box& area, const ValueRange& x, const ValueRange& y, const SweepTheme& theme)
        : area_(area), theme_(theme), x_(x), y_(y), left_(area.min.x() + plotLeft), right_(area.max.x() - plotRight),
          top_(area.min.y() + plotAbove), bottom_(area.max.y() - plotBelow) {}

    double atX(double value) const { return left_ + (value - x_.low) / (x_.high - x_.low) * (right_ - left_); }
    double atY(double value) const { return bottom_ - (value - y_.low) / (y_.high - y_.low) * (bottom_ - top_); }
    Point at(double x, double y) const { return {atX(x), atY(y)}; }
    double right() const { return right_; }
    double top() const { return top_; }
    double bottom() const { return bottom_; }

    void drawAxes(Ink& ink, const std::string& xTitle, const std::string& yTitle) const {
        const TextStyle tick = inInk(text_style::tick, theme_.text), body = inInk(text_style::body, theme_.text);
        const Ticks xTicks = roundTicks(x_, mostTicks), yTicks = roundTicks(y_, mostTicks);
        for (const double value : xTicks.values) {
            ink.line({atX(value), bottom_}, {atX(value), top_}, {0.13, theme_.grid});
            ink.text({atX(value), bottom_ + 3.0}, numberText(value, xTicks.decimals), tick, Align::Centre);
        }
        for (const double value : yTicks.values) {
            ink.line({left_, atY(value)}, {right_, atY(value)}, {0.13, theme_.grid});
            ink.text({left_ - 1.0, atY(value) + 0.7}, numberText(value, yTicks.decimals), tick, Align::Right);
        }
        ink.line({left_, bottom_}, {right_, bottom_}, {0.15, theme_.axis});
        ink.line({left_, bottom_}, {left_, top_}, {0.15, theme_.axis});
        const std::string title = elided(xTitle, body, right_ - left_, true);
        ink.text({0.5 * (left_ + right_), bottom_ + 7.2}, title, body, Align::Centre);
        ink.text({area_.min.x(), top_ - 1.6}, elided(yTitle, body, right_ - left_, true), body);
    }

private:
    Box area_;
    const SweepTheme& theme_;
    ValueRange x_, y_;
    double left_, right_, top_, bottom_;
};

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
std::vector<Point> cumulative(const std::vector<double>& sorted, const LinearPlot& plot, double scale) {
    std::vector<Point> points;
    const std::size_t every = std::max<std::size_t>(1, sorted.size() / 400);
    for (std::size_t i = 0; i < sorted.size(); ++i)
        if (i % every == 0 || i + 1 == sorted.size())
            points.push_back(
                plot.at(sorted[i], scale * static_cast<double>(i + 1) / static_cast<double>(sorted.size())));
    return points;
}

LinearPlot scatterPlot(const ScatterChart& chart, const Box& area, const SweepTheme& theme) {
    const auto [left, right] = std::ranges::minmax(chart.dots, {}, &ScatterDot::x);
    const auto [low, high] = std::ranges::minmax(chart.dots, {}, &ScatterDot::y);
    return {area, sweepRange(left.x, right.x), sweepRange(low.y, high.y), theme};
}

}  // namespace

const SweepTheme& paperSweepTheme() {
    using namespace paper_theme;
    static const SweepTheme theme{white, black, axis, grid, rgb(0x7F84C8), rgb(0xC2410C), ribbon, error, rgb(0xD5D7EE)};
    return theme;
}

void drawHistogram(Ink& ink, const HistogramChart& chart, const Box& area, const SweepTheme& theme) {
    const int count = barsFor(chart.sorted);
    const std::vector<double> counts = countsOf(chart.sorted, count);
    const double low = chart.sorted.front(), wide = (chart.sorted.back() - low) / count;
    const ValueRange y = sweepRange(0.0, *std::ranges::max_element(counts));
    const LinearPlot plot(area, sweepRange(low, chart.sorted.back()), y, theme);
    const TextStyle ofCurve{2.0, false, theme.curve};
    plot.drawAxes(ink, chart.axis, "Cases");
    for (int i = 0; i < count; ++i)
        if (counts[i] > 0.0)
            ink.box({{plot.atX(low + i * wide), plot.atY(counts[i])},
                     {std::max(plot.atX(low + (i + 1) * wide), plot.atX(low + i * wide) + 0.4), plot.bottom()}},
                    theme.bars, Stroke{0.1, theme.ground});
    ink.polyline(cumulative(chart.sorted, plot, y.high), {0.3, theme.curve});
    for (const int percent : {0, 50, 100})
        ink.text({plot.right() + 1.0, plot.atY(y.high * percent / 100.0) + 0.7}, std::to_string(percent) + " %",
                 ofCurve);
    ink.text({plot.right() + plotRight, plot.top() - 1.6}, "cumulative", ofCurve, Align::Right);
}

void drawScatter(Ink& ink, const ScatterChart& chart, const Box& area, const SweepTheme& theme) {
    const LinearPlot plot = scatterPlot(chart, area, theme);
    plot.drawAxes(ink, chart.xAxis, chart.yAxis);
    const double radius = chart.dots.size() > 2000 ? 0.25 : 0.45;
    for (const bool isMarked : {false, true})
        for (const ScatterDot& d : chart.dots)
            if (d.isMarked == isMarked)
                ink.circle(plot.at(d.x, d.y), radius, isMarked ? theme.marked : theme.dots, std::nullopt);
    if (std::ranges::any_of(chart.dots, &ScatterDot::isMarked))
        ink.text({plot.right(), plot.top() - 1.6}, "red: the case fails", {2.0, false, theme.marked}, Align::Right);
}

std::vector<Point> dotPlaces(const ScatterChart& chart, const Box& area) {
    const LinearPlot plot = scatterPlot(chart, area, paperSweepTheme());
    std::vector<Point> places;
    for (const ScatterDot& d : chart.dots) places.push_back(plot.at(d.x, d.y));
    return places;
}

double tornadoHeight(const TornadoChart& chart) {
    return plotAbove + barRow * static_cast<double>(std::min(chart.bars.size(), mostBars)) + plotBelow;
}

void drawTornado(Ink& ink, const TornadoChart& chart, const Box& area, const SweepTheme& theme) {
    const std::size_t count = std::min(chart.bars.size(), mostBars);
    const double left = area.min.x() + barNameRoom, right = area.max.x() - barEndRoom, top = area.min.y() + plotAbove;
    const double row = std::min(barRow, (area.max.y() - plotBelow - top) / static_cast<double>(count));
    const double bottom = top + row * static_cast<double>(count), middle = 0.5 * (left + right);
    const TextStyle tick = inInk(text_style::tick, theme.text), body = inInk(text_style::body, theme.text);
    const auto at = [&](double value) { return middle + value * 0.5 * (right - left); };
    for (const double value : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        ink.line({at(value), bottom}, {at(value), top}, {0.13, value == 0.0 ? theme.axis : theme.grid});
        ink.text({at(value), bottom + 3.0}, numberText(value, 1), tick, Align::Centre);
    }
    ink.text({middle, bottom + 7.2}, "Rank correlation", body, Align::Centre);
    for (std::size_t i = 0; i < count; ++i) {
        const TornadoBar& bar = chart.bars[i];
        const double y = top + row * (static_cast<double>(i) + 0.5), end = at(bar.value);
        ink.box({{std::min(middle, end), y - 0.3 * row}, {std::max(middle, end), y + 0.3 * row}},
                bar.value < 0.0 ? theme.curve : theme.bars, std::nullopt);
        ink.text({left - 1.5, y + 0.7}, elided(bar.name, body, barNameRoom - 2.0, true), body, Align::Right);
        ink.casedText({end + (bar.value < 0.0 ? -1.0 : 1.0), y + 0.7}, numberText(bar.value, 2), tick,
                      bar.value < 0.0 ? Align::Right : Align::Left, theme.ground);
    }
}

void drawConvergence(Ink& ink, const ConvergenceChart& chart, const Box& area, const SweepTheme& theme) {
    const std::size_t settled = std::min<std::size_t>(chart.points.size() - 1, chart.points.size() / 20);
    double high = 0.0;  // the first few intervals are much wider than the rest
    for (std::size_t i = settled; i < chart.points.size(); ++i) high = std::max(high, chart.points[i].high);
    const ValueRange y = sweepRange(0.0, std::min(1.0, high));
    const LinearPlot plot(area, sweepRange(0.0, chart.points.back().cases), y, theme);
    plot.drawAxes(ink, "Cases", "Probability of failure");
    std::vector<Point> outline, line;
    const auto inside = [&](double value) { return std::min(value, y.high); };
    for (const ChancePoint& p : chart.points) outline.push_back(plot.at(p.cases, inside(p.low)));
    for (auto p = chart.points.rbegin(); p != chart.points.rend(); ++p)
        outline.push_back(plot.at(p->cases, inside(p->high)));
    for (const ChancePoint& p : chart.points) line.push_back(plot.at(p.cases, inside(p.probability)));
    ink.polygon(outline, theme.band, std::nullopt);
    ink.polyline(line, {0.3, theme.dots});
    const ChancePoint& last = chart.points.back();
    ink.casedText({plot.right(), plot.atY(inside(last.high)) - 1.2}, numberText(last.probability),
                  inInk(text_style::number, theme.text), Align::Right, theme.ground);
}

}  // namespace keyblock
