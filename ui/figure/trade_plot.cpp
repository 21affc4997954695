// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/trade_plot.h"

#include "ui/picture/ticks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace keyblock {

namespace {

constexpr double titleRoom = 5.0, axisRoom = 10.0, leftRoom = 11.0, fullKeyRoom = 34.0, leastWidth = 95.0;  // [mm]
constexpr double dotRadius = 0.75, frontRadius = 1.05, keyRow = 3.6, nameGap = 1.6, nameHeight = 2.2;  // [mm]
constexpr double leastError = 1e-7;  // smaller errors are round-off; they are drawn at the lower edge
constexpr double leastTime = 1e-4;  // [s]

std::string tickText(double value) {
    return numberText(value, std::max(0, -static_cast<int>(std::floor(std::log10(value) + 1e-9))));
}

bool overlap(const Box& a, const Box& b) {
    return a.min.x() < b.max.x() && b.min.x() < a.max.x() && a.min.y() < b.max.y() && b.min.y() < a.max.y();
}

}  // namespace

LogAxis::LogAxis(double low, double high, double from, double to)
    : low_(std::log10(low)), high_(std::log10(high)), from_(from), to_(to) {}

double LogAxis::at(double value) const { return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_); }

std::vector<double> LogAxis::ticks() const {
    std::vector<double> values;
    const bool fine = high_ - low_ < 2.5;
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade)
        for (const double factor : fine ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0})
            if (const double value = factor * std::pow(10.0, decade);
                std::log10(value) >= low_ && std::log10(value) <= high_)
                values.push_back(value);
    return values;
}

TradePlot::TradePlot(TradeChart chart, const Box& area, const ChartTheme& theme)
    : chart_(std::move(chart)), theme_(theme), keyRoom_(area.max.x() - area.min.x() >= leastWidth ? fullKeyRoom : 0.0),
      left_(area.min.x() + leftRoom), right_(area.max.x() - std::max(keyRoom_, 2.0)), top_(area.min.y() + titleRoom),
      bottom_(area.max.y() - axisRoom), floor_(leastError), time_(timeAxis()), error_(errorAxis()) {
    for (const TradeDot& dot : chart_.dots)
        if (std::isfinite(dot.error) && !std::count(axes_.begin(), axes_.end(), dot.axis)) axes_.push_back(dot.axis);
}

bool TradePlot::canShow(const TradeChart& chart) {
    return std::any_of(chart.dots.begin(), chart.dots.end(),
                       [](const TradeDot& dot) { return std::isfinite(dot.error); });
}

void TradePlot::draw(Ink& ink) {
    drawAxes(ink);
    drawFront(ink);
    for (const bool front : {false, true})
        for (const TradeDot& dot : chart_.dots)
            if (std::isfinite(dot.error) && dot.onFront == front) drawDot(ink, dot);
    taken_.clear();
    const Point corner(dotRadius, dotRadius);
    for (const TradeDot& dot : chart_.dots)
        if (std::isfinite(dot.error)) taken_.push_back({placeOf(dot) - corner, placeOf(dot) + corner});
    for (const TradeDot& dot : chart_.dots)
        if (std::isfinite(dot.error) && dot.isNamed) drawName(ink, dot);
    if (keyRoom_ > 0.0) drawKey(ink);
}

int TradePlot::dotAt(const Point& place, double reach) const {
    int nearest = -1;
    double least = reach;
    for (std::size_t i = 0; i < chart_.dots.size(); ++i) {
        if (!std::isfinite(chart_.dots[i].error)) continue;
        const double distance = (placeOf(chart_.dots[i]) - place).norm();
        if (distance > least) continue;
        least = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

LogAxis TradePlot::timeAxis() const {
    assert(canShow(chart_));
    double low = 1e300, high = 0.0;
    for (const TradeDot& dot : chart_.dots) {
        if (!std::isfinite(dot.error)) continue;
        low = std::min(low, dot.seconds);
        high = std::max(high, dot.seconds);
    }
    low = std::max(low, leastTime);
    return {low / 1.3, std::max(high, low) * 1.3, left_, right_};
}

/// From half the smallest error that is not round-off to the largest.
LogAxis TradePlot::errorAxis() {
    double low = 1.0, high = leastError;
    for (const TradeDot& dot : chart_.dots) {
        if (!std::isfinite(dot.error) || dot.error < leastError) continue;
        low = std::min(low, dot.error);
        high = std::max(high, dot.error);
    }
    high = std::max(high, low);
    floor_ = 0.3 * low;
    return {100.0 * floor_, 100.0 * high * 1.5, bottom_, top_};
}

Point TradePlot::placeOf(const TradeDot& dot) const {
    return {time_.at(std::max(dot.seconds, leastTime)), error_.at(100.0 * std::max(dot.error, floor_))};
}

Colour tradeColour(std::size_t number, const Colour& ground) {
    static constexpr std::array onLight{rgb(0x3A3FA8), rgb(0xC2410C), rgb(0x1B8A5A), rgb(0xE69F00), rgb(0x56B4E9),
                                        rgb(0x8C564B), rgb(0xCC79A7), rgb(0x6B747E), rgb(0x0E7C86), rgb(0xA8338F)};
    static constexpr std::array onDark{rgb(0x97A2FF), rgb(0xF2764B), rgb(0x4CC38A), rgb(0xF0B64A), rgb(0x7CC8F2),
                                       rgb(0xC49A8A), rgb(0xF0A8CB), rgb(0x98A2AF), rgb(0x3FB0BC), rgb(0xD46FBD)};
    const bool isDark = ground.red + ground.green + ground.blue < 3 * 128;
    return (isDark ? onDark : onLight)[number % onLight.size()];
}

Colour TradePlot::colourOf(const std::string& axis) const {
    const auto place = static_cast<std::size_t>(std::find(axes_.begin(), axes_.end(), axis) - axes_.begin());
    return place == 0 ? theme_.text : tradeColour(place - 1, theme_.ground);
}

TextStyle TradePlot::inked(TextStyle style) const {
    style.colour = theme_.text;
    return style;
}

void TradePlot::drawAxes(Ink& ink) const {
    for (const double value : time_.ticks()) {
        ink.line({time_.at(value), bottom_}, {time_.at(value), top_}, {0.13, theme_.grid});
        ink.text({time_.at(value), bottom_ + 3.0}, tickText(value), inked(text_style::tick), Align::Centre);
    }
    for (const double value : error_.ticks()) {
        ink.line({left_, error_.at(value)}, {right_, error_.at(value)}, {0.13, theme_.grid});
        if (bottom_ - error_.at(value) > nameHeight)  // above the 0
            ink.text({left_ - 1.0, error_.at(value) + 0.7}, tickText(value), inked(text_style::tick), Align::Right);
    }
    ink.text({left_ - 1.0, bottom_ + 0.7}, "0", inked(text_style::tick), Align::Right);
    ink.line({left_, bottom_}, {right_, bottom_}, {0.15, theme_.axis});
    ink.line({left_, bottom_}, {left_, top_}, {0.15, theme_.axis});
    ink.text({0.5 * (left_ + right_), bottom_ + 7.2}, "Time of the run, s", inked(text_style::body), Align::Centre);
    ink.text({left_ - leftRoom, top_ - 1.6}, "Largest error, %", inked(text_style::body));
}

void TradePlot::drawFront(Ink& ink) const {
    std::vector<Point> line;
    for (const TradeDot& dot : chart_.dots)
        if (dot.onFront) line.push_back(placeOf(dot));
    std::sort(line.begin(), line.end(), [](const Point& a, const Point& b) { return a.x() < b.x(); });
    if (line.size() > 1) ink.polyline(line, {0.25, theme_.softText, {1.2, 0.8}});
}

void TradePlot::drawDot(Ink& ink, const TradeDot& dot) const {
    ink.circle(placeOf(dot), dot.onFront ? frontRadius : dotRadius, colourOf(dot.axis), Stroke{0.15, theme_.ground});
}

/// Writes the name beside its dot, on the side where there is room, unless another dot or name or the title of the axis is
/// there.
void TradePlot::drawName(Ink& ink, const TradeDot& dot) {
    const Point at = placeOf(dot);
    const double room = std::max(at.x() - left_, right_ + keyRoom_ - at.x()) - nameGap;
    const std::string name = elided(dot.name, text_style::body, std::min(60.0, room), true);
    const double width = textWidth(name, text_style::body);
    const bool toRight = at.x() + nameGap + width <= right_;
    for (const double shift : {0.7, -2.0, 3.2, -4.4, 5.6}) {
        const double from = toRight ? at.x() + nameGap : at.x() - nameGap - width;
        const Box box{{from, at.y() + shift - nameHeight}, {from + width, at.y() + shift}};
        if (box.max.y() > bottom_ + 0.8 || box.min.y() < top_ - 0.5 ||
            std::any_of(taken_.begin(), taken_.end(), [&](const Box& other) { return overlap(other, box); }))
            continue;
        taken_.push_back(box);
        ink.casedText({from, at.y() + shift}, name, inked(text_style::body), Align::Left, theme_.ground);
        return;
    }
}

void TradePlot::drawKey(Ink& ink) const {
    const double x = right_ + 5.0;
    double y = top_ + 2.0;
    for (const std::string& axis : axes_) {
        ink.circle({x, y - 0.7}, dotRadius, colourOf(axis), std::nullopt);
        ink.text({x + 2.0, y}, elided(axis, text_style::body, keyRoom_ - 7.0, true), inked(text_style::body));
        y += keyRow;
    }
    ink.line({x - 1.0, y - 0.7}, {x + 1.0, y - 0.7}, {0.25, theme_.softText, {1.2, 0.8}});
    ink.text({x + 2.0, y}, "front", inked(text_style::body));
}

}  // namespace keyblock
