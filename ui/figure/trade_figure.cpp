// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/trade_figure.h"

#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"
#include "ui/picture/ticks.h"

#include <qcustomplot.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double chartHeight = 82.0, titleRoom = 5.0, axisRoom = 10.0, leftRoom = 11.0, keyRoom = 34.0;  // [mm]
constexpr double dot = 0.75, frontDot = 1.05, keyRow = 3.6, nameGap = 1.6, nameHeight = 2.2;  // [mm]
constexpr double leastError = 1e-7;  // smaller errors are round-off; they are drawn at the lower edge

/// A logarithmic axis over whole decades, or parts of one.
class LogAxis {
public:
    LogAxis(double low, double high, double from, double to)
        : low_(std::log10(low)), high_(std::log10(high)), from_(from), to_(to) {}

    double at(double value) const { return from_ + (std::log10(value) - low_) / (high_ - low_) * (to_ - from_); }

    /// 1, 2 and 5 times the powers of ten in the range; only the powers if there are many.
    std::vector<double> ticks() const {
        std::vector<double> values;
        const bool fine = high_ - low_ < 2.5;
        for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade)
            for (const double factor : fine ? std::vector{1.0, 2.0, 5.0} : std::vector{1.0})
                if (const double value = factor * std::pow(10.0, decade);
                    std::log10(value) >= low_ && std::log10(value) <= high_)
                    values.push_back(value);
        return values;
    }

private:
    double low_, high_, from_, to_;
};

std::string tickText(double value) {
    return numberText(value, std::max(0, -static_cast<int>(std::floor(std::log10(value) + 1e-9))));
}

class TradePainter {
public:
    TradePainter(const TradeChart& chart, const Sheet& sheet)
        : chart_(chart), left_(margin + leftRoom), right_(sheet.width() - margin - keyRoom),
          top_(sheet.top() + titleRoom), bottom_(top_ + chartHeight), time_(timeAxis()), error_(errorAxis()) {
        for (const TradeDot& d : chart.dots)
            if (std::isfinite(d.error) && !std::count(axes_.begin(), axes_.end(), d.axis)) axes_.push_back(d.axis);
    }

    void draw(Ink& ink) {
        drawAxes(ink);
        drawFront(ink);
        for (const bool front : {false, true})
            for (const TradeDot& d : chart_.dots)
                if (std::isfinite(d.error) && d.onFront == front) drawDot(ink, d);
        for (const TradeDot& d : chart_.dots)
            if (std::isfinite(d.error)) taken_.push_back({placeOf(d) - Point(dot, dot), placeOf(d) + Point(dot, dot)});
        for (const TradeDot& d : chart_.dots)
            if (std::isfinite(d.error) && d.isNamed) drawName(ink, d);
        drawKey(ink);
    }

private:
    LogAxis timeAxis() const {
        double low = 1e300, high = 0.0;
        for (const TradeDot& d : chart_.dots) {
            if (!std::isfinite(d.error)) continue;
            low = std::min(low, d.seconds);
            high = std::max(high, d.seconds);
        }
        if (high == 0.0) throw CannotDraw("no run of this trade has a result");
        low = std::max(low, 1e-4);
        return {low / 1.3, std::max(high, low) * 1.3, left_, right_};
    }

    /// From half the smallest error that is not round-off, where errors of 0 are drawn, to the largest.
    LogAxis errorAxis() {
        double low = 1.0, high = leastError;
        for (const TradeDot& d : chart_.dots) {
            if (!std::isfinite(d.error) || d.error < leastError) continue;
            low = std::min(low, d.error);
            high = std::max(high, d.error);
        }
        high = std::max(high, low);
        floor_ = 0.3 * low;
        return {100.0 * floor_, 100.0 * high * 1.5, bottom_, top_};
    }

    Point placeOf(const TradeDot& d) const {
        return {time_.at(std::max(d.seconds, 1e-4)), error_.at(100.0 * std::max(d.error, floor_))};
    }

    Colour colourOf(const std::string& axis) const {
        static constexpr std::array colours{rgb(0x000000), rgb(0x3A3FA8), rgb(0xC2410C), rgb(0x1B8A5A),
                                            rgb(0xE69F00), rgb(0x56B4E9), rgb(0x8C564B), rgb(0xCC79A7),
                                            rgb(0x6B747E), rgb(0x0E7C86), rgb(0xA8338F)};
        const auto place = std::find(axes_.begin(), axes_.end(), axis) - axes_.begin();
        return colours[static_cast<std::size_t>(place) % colours.size()];
    }

    void drawAxes(Ink& ink) const {
        for (const double value : time_.ticks()) {
            ink.line({time_.at(value), bottom_}, {time_.at(value), top_}, {0.13, grid});
            ink.text({time_.at(value), bottom_ + 3.0}, tickText(value), text_style::tick, Align::Centre);
        }
        for (const double value : error_.ticks()) {
            ink.line({left_, error_.at(value)}, {right_, error_.at(value)}, {0.13, grid});
            ink.text({left_ - 1.0, error_.at(value) + 0.7}, tickText(value), text_style::tick, Align::Right);
        }
        ink.text({left_ - 1.0, bottom_ + 0.7}, "0", text_style::tick, Align::Right);
        ink.line({left_, bottom_}, {right_, bottom_}, {0.15, axis});
        ink.line({left_, bottom_}, {left_, top_}, {0.15, axis});
        ink.text({0.5 * (left_ + right_), bottom_ + 7.2}, "Time of the run, s", text_style::body, Align::Centre);
        ink.text({margin, top_ - 1.6}, "Largest error, %", text_style::body);
    }

    void drawFront(Ink& ink) const {
        std::vector<Point> line;
        for (const TradeDot& d : chart_.dots)
            if (d.onFront) line.push_back(placeOf(d));
        std::sort(line.begin(), line.end(), [](const Point& a, const Point& b) { return a.x() < b.x(); });
        if (line.size() > 1) ink.polyline(line, {0.25, softText, {1.2, 0.8}});
    }

    void drawDot(Ink& ink, const TradeDot& d) const {
        ink.circle(placeOf(d), d.onFront ? frontDot : dot, colourOf(d.axis), Stroke{0.15, white});
    }

    /// Writes the name beside its dot, on the side where there is room, unless another dot or name is there.
    void drawName(Ink& ink, const TradeDot& d) {
        const Point at = placeOf(d);
        const double room = std::max(at.x() - left_, right_ + keyRoom - at.x()) - nameGap;
        const std::string name = elided(d.name, text_style::body, std::min(60.0, room), true);
        const double width = textWidth(name, text_style::body);
        const bool toRight = at.x() + nameGap + width <= right_;
        for (const double shift : {0.7, -2.0, 3.2, -4.4, 5.6}) {
            const double from = toRight ? at.x() + nameGap : at.x() - nameGap - width;
            const Box box{{from, at.y() + shift - nameHeight}, {from + width, at.y() + shift}};
            if (box.max.y() > bottom_ + 0.8 ||
                std::any_of(taken_.begin(), taken_.end(), [&](const Box& b) { return overlap(b, box); }))
                continue;
            taken_.push_back(box);
            ink.casedText({from, at.y() + shift}, name, text_style::body);
            return;
        }
    }

    static bool overlap(const Box& a, const Box& b) {
        return a.min.x() < b.max.x() && b.min.x() < a.max.x() && a.min.y() < b.max.y() && b.min.y() < a.max.y();
    }

    void drawKey(Ink& ink) const {
        const double x = right_ + 5.0;
        double y = top_ + 2.0;
        for (const std::string& axis : axes_) {
            ink.circle({x, y - 0.7}, dot, colourOf(axis), std::nullopt);
            ink.text({x + 2.0, y}, elided(axis, text_style::body, keyRoom - 7.0, true), text_style::body);
            y += keyRow;
        }
        ink.line({x - 1.0, y - 0.7}, {x + 1.0, y - 0.7}, {0.25, softText, {1.2, 0.8}});
        ink.text({x + 2.0, y}, "front", text_style::body);
    }

    const TradeChart& chart_;
    double left_, right_, top_, bottom_;
    double floor_ = leastError;
    LogAxis time_, error_;
    std::vector<std::string> axes_;
    std::vector<Box> taken_;  // by dots and names
};

}  // namespace

std::string paintTrade(const TradeChart& chart, PaperFormat format, double width) {
    const Sheet sheet(width, chart.title, chart.subtitle, {});
    const double height = std::ceil(sheet.heightAround(titleRoom + chartHeight + axisRoom));
    Paper paper(format, width, height, 300, chart.title);
    Ink ink(paper.painter());
    sheet.draw(ink, height, chart.foot);
    TradePainter(chart, sheet).draw(ink);
    return paper.finish();
}

}  // namespace keyblock
