// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Appearance of tools on the canvas: previews, snap marks, dimensions and the prompt,
// with sizes in pixels and in the colours of the theme.
#pragma once

#include "ui/edit/anchor_edit.h"
#include "ui/edit/scene_objects.h"
#include "ui/edit/snap.h"

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace keyblock {

class CanvasMap;
struct Theme;

/// Paints on one view, in the colours of one theme.
class ToolPainter {
public:
    ToolPainter(QPainter& painter, const CanvasMap& map, const Theme& theme);

    /// A line that is not committed yet: accent colour, dashed (dash 7 px, gap 4 px).
    void ghost(const std::vector<Point>& points, bool closed = false, double width = 1.6);
    void ghostFill(const std::vector<Point>& outline);
    /// A selected line: accent colour, solid.
    void chosen(const std::vector<Point>& points, bool closed, double width = 2.0);
    /// Highlight of a line under the mouse.
    void near(const std::vector<Point>& points, bool closed);
    /// A wall that has been picked.
    void wall(const std::vector<Point>& points);
    /// Preview of a bolt: dashed shank, its nodes, and a hollow face plate at the head.
    void bolt(const Point& head, const Point& farEnd, bool plate, const std::vector<NodeAhead>& nodes);

    void corner(const Point& place);  // handle, 9 px square
    void handle(const Point& place, bool hot);
    void dot(const Point& place);

    /// A dimension between two points, with its text in a box. The dimension line is shifted by `off` pixels to the
    /// left of the line from `from` to `to`.
    void dimension(const Point& from, const Point& to, const QString& text, double off);
    /// A short text in a small box, centred at `at` [px].
    void label(const QPointF& at, const QString& text);

    /// The mark of a snap point, with its name on a dark tag.
    void snap(const Snap& snap);
    void box(const QRectF& box, bool crosses);
    void grid(double spacing);

    /// The strip at the top left of the canvas: bold prompt, detail, and a coloured left edge 3 px wide. Returns its
    /// rectangle.
    /// \param room width available [px]
    static QRectF prompt(QPainter& painter, const Theme& theme, const QString& text, const QString& detail, bool warns,
                         double room);

private:
    QPolygonF pixels(const std::vector<Point>& points) const;

    QPainter& painter_;
    const CanvasMap& map_;
    const Theme& theme_;
};

/// A length as text: `1.00 m`, `12.35 m`, `0.125 m`.
QString lengthText(double metres);
/// An angle as text: `35.0°`.
QString angleText(double degrees);
/// A number in an option of a tool, with few digits and a true minus sign.
QString fieldText(double number);
/// An area as text: `15.59 m²`.
QString areaText(double squareMetres);
/// A point as text: `−2.50, 0.25`.
QString placeText(const Point& place);

}  // namespace keyblock
