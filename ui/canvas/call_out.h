// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panels over the canvas, and call-outs that point from a panel to a location. A
// call-out has a bold line, a line with details, and an edge in the colour of the state
// that it reports.
#pragma once

#include "geometry/point.h"

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QSizeF>
#include <QString>

class QPainter;

namespace keyblock {

struct Theme;

/// The window's font at the given size [px].
QFont screenFont(int pixels, bool bold = false);

/// Paints a panel with a thin border and rounded corners.
void paintPanel(QPainter& painter, const Theme& theme, const QRectF& rect);

struct CallOut {
    QString head, detail;  // first and second line; the second may be empty
    QColor edge;
    Point at{0.0, 0.0};  // location to which it points [px]
    Point first{0.0, -1.0};  // preferred direction from there to the panel
    bool hasFoot = false;  // draw a dot at the location
};

QSizeF sizeOf(const CallOut& callOut);
void paintCallOut(QPainter& painter, const Theme& theme, const CallOut& callOut, const QRectF& rect);

/// Paints text with an outline in the theme's colour `markCasing`, so that it is readable over lines.
/// \param at left end of the baseline [px].
void paintCased(QPainter& painter, const Theme& theme, const QPointF& at, const QString& text, const QColor& colour);

}  // namespace keyblock
