// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/ink.h"

#include "ui/figure/application.h"
#include "ui/figure/paper.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QGlyphRun>
#include <QPainter>
#include <QPainterPath>
#include <QRawFont>
#include <QTextLayout>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace keyblock {

namespace {

QPointF units(const Point& mm) { return {mm.x() * unitsPerMm, mm.y() * unitsPerMm}; }
QColor colourOf(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

QPen penOf(const Stroke& stroke) {
    QPen pen(colourOf(stroke.colour), stroke.width * unitsPerMm);
    pen.setJoinStyle(Qt::RoundJoin);
    pen.setCapStyle(stroke.dashes.empty() ? Qt::RoundCap : Qt::FlatCap);
    if (!stroke.dashes.empty()) {
        QVector<qreal> pattern;
        for (const double length : stroke.dashes) pattern.push_back(length / stroke.width);
        pen.setDashPattern(pattern);
    }
    return pen;
}

QPolygonF polygonOf(const std::vector<Point>& points) {
    QPolygonF polygon;
    polygon.reserve(static_cast<int>(points.size()));
    for (const Point& point : points) polygon.push_back(units(point));
    return polygon;
}

/// The font family of figures: the first of these that is installed.
const QString& family() {
    static const QString found = [] {
        const QStringList installed = QFontDatabase().families();
        for (const char* name : {"Inter", "Noto Sans", "DejaVu Sans"})
            if (installed.contains(name)) return QString(name);
        return QFont().defaultFamily();
    }();
    return found;
}

QString qt(const std::string& text) { return QString::fromStdString(text); }

/// Whether shaping inserts glyphs that correspond to no character, as it does in Inter for a colon after a capital
/// letter. The text of a PDF with such glyphs could not be searched.
bool swapsGlyphs(const QFont& font, const QString& text) {
    QTextLayout layout(text, font);
    layout.beginLayout();
    layout.createLine();
    layout.endLayout();
    for (const QGlyphRun& run : layout.glyphRuns()) {
        const QVector<quint32> own = run.rawFont().glyphIndexesForString(text);
        for (const quint32 glyph : run.glyphIndexes())
            if (!own.contains(glyph)) return true;
    }
    return false;
}

/// The font for this text. Shaping is switched off if it would insert other glyphs, except in scripts that need it.
QFont fontFor(const TextStyle& style, const QString& text) {
    QFont font = fontOf(style);
    const bool simple = std::all_of(text.begin(), text.end(), [](QChar c) {
        return c.unicode() < 0x0590 || (c.unicode() >= 0x2000 && c.unicode() < 0x2300);
    });
    if (simple && swapsGlyphs(font, text)) font.setStyleStrategy(QFont::PreferNoShaping);
    return font;
}

QPointF startOf(const Point& at, const QString& text, const QFont& font, Align align) {
    QPointF start = units(at);
    const double width = QFontMetricsF(font).horizontalAdvance(text);
    if (align == Align::Centre) start.rx() -= 0.5 * width;
    if (align == Align::Right) start.rx() -= width;
    return start;
}

}  // namespace

QFont fontOf(const TextStyle& style) {
    needApplication();
    QFont font(family());
    font.setPixelSize(static_cast<int>(std::lround(style.size * unitsPerMm)));
    font.setWeight(style.bold ? QFont::DemiBold : QFont::Normal);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

Ink::Ink(QPainter& painter) : painter_(painter) {}

void Ink::line(const Point& a, const Point& b, const Stroke& stroke) {
    painter_.setPen(penOf(stroke));
    painter_.drawLine(units(a), units(b));
}

void Ink::polyline(const std::vector<Point>& points, const Stroke& stroke) {
    painter_.setPen(penOf(stroke));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(polygonOf(points));
}

void Ink::polygon(const std::vector<Point>& points, const std::optional<Colour>& fill,
                  const std::optional<Stroke>& stroke, double opacity) {
    QColor colour = fill ? colourOf(*fill) : QColor();
    if (fill) colour.setAlphaF(opacity);
    painter_.setBrush(fill ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter_.setPen(stroke ? penOf(*stroke) : QPen(Qt::NoPen));
    painter_.drawPolygon(polygonOf(points));
}

void Ink::box(const Box& box, const std::optional<Colour>& fill, const std::optional<Stroke>& stroke) {
    polygon({box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}, fill, stroke);
}

void Ink::circle(const Point& centre, double radius, const std::optional<Colour>& fill,
                 const std::optional<Stroke>& stroke) {
    painter_.setBrush(fill ? QBrush(colourOf(*fill)) : QBrush(Qt::NoBrush));
    painter_.setPen(stroke ? penOf(*stroke) : QPen(Qt::NoPen));
    painter_.drawEllipse(units(centre), radius * unitsPerMm, radius * unitsPerMm);
}

void Ink::text(const Point& at, const std::string& text, const TextStyle& style, Align align) {
    const QFont font = fontFor(style, qt(text));
    painter_.setFont(font);
    painter_.setPen(colourOf(style.colour));
    painter_.drawText(startOf(at, qt(text), font, align), qt(text));
}

void Ink::casedText(const Point& at, const std::string& text, const TextStyle& style, Align align,
                    const Colour& ground) {
    const QFont font = fontFor(style, qt(text));
    QPainterPath rim;
    rim.addText(startOf(at, qt(text), font, align), font, qt(text));
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(penOf({0.95, ground}));
    painter_.drawPath(rim);
    const QRectF whole = rim.boundingRect();  // also covers the gaps between the letters
    painter_.fillRect(QRectF(whole.left(), units(at).y() - 0.6 * style.size * unitsPerMm, whole.width(),
                             0.75 * style.size * unitsPerMm),
                      colourOf(ground));
    this->text(at, text, style, align);
}

double textWidth(const std::string& text, const TextStyle& style) {
    return QFontMetricsF(fontFor(style, qt(text))).horizontalAdvance(qt(text)) / unitsPerMm;
}

std::string elided(const std::string& text, const TextStyle& style, double width, bool middle) {
    return QFontMetricsF(fontFor(style, qt(text)))
        .elidedText(qt(text), middle ? Qt::ElideMiddle : Qt::ElideRight, width * unitsPerMm)
        .toStdString();
}

std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, double width, std::size_t most) {
    std::vector<std::string> lines{""};
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || lines.size() == most || textWidth(longer, style) <= width) lines.back() = longer;
        else lines.push_back(word);
    }
    for (std::string& line : lines) line = elided(line, style, width);
    return lines;
}

}  // namespace keyblock
