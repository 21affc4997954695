// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strokes, fills and texts in millimetres, y downwards. All figures are drawn with
// these functions, independently of the output device.
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
    std::vector<double> dashes{};  // lengths of dashes and gaps in turn [mm]; empty: solid
};

struct TextStyle {
    double size = 2.2;  // font size [mm]
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
    /// Draws a polygon; fill or outline may be left out.
    void polygon(const std::vector<Point>& points, const std::optional<Colour>& fill,
                 const std::optional<Stroke>& stroke, double opacity = 1.0);
    void box(const Box& box, const std::optional<Colour>& fill, const std::optional<Stroke>& stroke);
    void circle(const Point& centre, double radius, const std::optional<Colour>& fill,
                const std::optional<Stroke>& stroke);

    /// \param at position on the baseline of the text.
    void text(const Point& at, const std::string& text, const TextStyle& style, Align align = Align::Left);
    /// Draws text with an outline in the colour of the ground, so that it is readable over lines.
    void casedText(const Point& at, const std::string& text, const TextStyle& style, Align align = Align::Left,
                   const Colour& ground = paper_theme::white);

    QPainter& painter() { return painter_; }

private:
    QPainter& painter_;
};

/// Width of the text [mm].
double textWidth(const std::string& text, const TextStyle& style);

/// The text, shortened with an ellipsis if it is wider than `width` [mm].
/// \param middle true: the middle of the text is left out, for names that differ only at their ends.
std::string elided(const std::string& text, const TextStyle& style, double width, bool middle = false);

/// The text broken into lines of at most `width` [mm]. If it needs more than `most` lines, the last one is shortened
/// with an ellipsis.
std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width, std::size_t most);

/// The font of a text style, with its size converted from millimetres to drawing units.
QFont fontOf(const TextStyle& style);

}  // namespace keyblock
