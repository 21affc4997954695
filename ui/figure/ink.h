// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strokes, fills and texts in millimetres, y downwards. All drawing of figures uses
// this, independent of the device.
#pragma once

#include "geometry/polygon.h"
#include "ui/picture/colour.h"

#include <optional>
#include <string>
#include <vector>

class QPainter;
class QFont;

namespace keyblock {

namespace paper_theme {
inline constexpr Colour black = rgb(0x000000), white = rgb(0xFFFFFF), softText = rgb(0x4A5260),
                        joint = rgb(0x6B747E), seam = rgb(0xA9AFB6), rock = rgb(0xEDEBE6), error = rgb(0xC2262E),
                        slipping = rgb(0xE69F00), yielded = rgb(0xA8338F), ribbon = rgb(0x3A3FA8),
                        grid = rgb(0xECEEF1), axis = rgb(0xB4BAC3);
inline constexpr double margin = 6.0, gutter = 5.0, column = 41.0;  // [mm]
inline constexpr double frame = 0.2, wall = 0.32, jointLine = 0.13, seamLine = 0.08, leader = 0.17;  // [mm]
}  // namespace paper_theme

struct Stroke {
    double width = 0.2;  // [mm]
    Colour colour = paper_theme::black;
    std::vector<double> dashes{};  // on, off [mm]; empty: solid
};

struct TextStyle {
    double size = 2.2;  // of the font [mm]
    bool bold = false;
    Colour colour = paper_theme::black;
};

namespace text_style {
inline const TextStyle title{3.2, true}, heading{2.3, true}, label{2.3}, body{2.0}, tick{2.0},
    note{2.0, false, paper_theme::softText}, subtitle{2.1, false, paper_theme::softText},
    foot{1.8, false, paper_theme::softText}, number{2.0, true};
}

enum class Align { Left, Centre, Right };

class Ink {
public:
    explicit Ink(QPainter& painter);

    void line(const Point& a, const Point& b, const Stroke& stroke);
    void polyline(const std::vector<Point>& points, const Stroke& stroke);
    /// Either may be missing.
    void polygon(const std::vector<Point>& points, const std::optional<Colour>& fill,
                 const std::optional<Stroke>& stroke, double opacity = 1.0);
    void box(const Box& box, const std::optional<Colour>& fill, const std::optional<Stroke>& stroke);
    void circle(const Point& centre, double radius, const std::optional<Colour>& fill,
                const std::optional<Stroke>& stroke);

    /// `at` is on the baseline.
    void text(const Point& at, const std::string& text, const TextStyle& style, Align align = Align::Left);
    /// The same with a white rim, so that it can be read over lines.
    void casedText(const Point& at, const std::string& text, const TextStyle& style, Align align = Align::Left);

    QPainter& painter() { return painter_; }

private:
    QPainter& painter_;
};

/// Width of a text [mm].
double textWidth(const std::string& text, const TextStyle& style);

/// The text, elided if it is too long for `width` [mm]; in the middle, as names differ at their ends.
std::string elided(const std::string& text, const TextStyle& style, double width, bool middle = false);

/// Lines of at most `width` [mm], at most `most` of them; the last one elided.
std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width, std::size_t most);

/// The font of a style in units of the paper.
QFont fontOf(const TextStyle& style);

}  // namespace keyblock
