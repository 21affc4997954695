// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How tools look on the canvas: previews, snap marks, dimensions, the prompt. In
// pixels, in the colours of the theme.
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

/// Paints in one theme over one view.
class ToolPainter {
public:
    ToolPainter(QPainter& painter, const CanvasMap& map, const Theme& theme);

    /// Not committed yet: accent, dashed 7–4.
    void ghost(const std::vector<Point>& points, bool closed = false, double width = 1.6);
    void ghostFill(const std::vector<Point>& outline);
    /// Selected: accent, solid.
    void chosen(const std::vector<Point>& points, bool closed, double width = 2.0);
    /// Under the mouse.
    void near(const std::vector<Point>& points, bool closed);
    /// A wall that is picked.
    void wall(const std::vector<Point>& points);
    /// Preview of a bolt: dashed shank, its nodes, hollow plate at the head.
    void bolt(const Point& head, const Point& farEnd, bool plate, const std::vector<NodeAhead>& nodes);

    void corner(const Point& place);  // 9 px square of a handle
    void handle(const Point& place, bool hot);
    void dot(const Point& place);

    /// A length between two points, `off` pixels to the left of the line, in a white box.
    void dimension(const Point& from, const Point& to, const QString& text, double off);
    /// A small text in a panel next to a point.
    void label(const QPointF& at, const QString& text);

    /// The mark of a snap with its name on a dark tag.
    void snap(const Snap& snap);
    void box(const QRectF& box, bool crosses);
    void grid(double spacing);

    /// The strip at the top left: bold prompt, detail, 3 px edge.
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
/// A number in a field of a tool: few digits, true minus.
QString fieldText(double number);
/// An area as text: `15.59 m²`.
QString areaText(double squareMetres);
/// `−2.50, 0.25`
QString placeText(const Point& place);

}  // namespace keyblock
