// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Panels over the canvas, and call-outs that point from a panel to a location: a
// bold line, a line of details, an edge in the colour of the state.
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

/// The window's font at another size [px].
QFont screenFont(int pixels, bool bold = false);

/// A panel with a thin border and round corners.
void paintPanel(QPainter& painter, const Theme& theme, const QRectF& rect);

struct CallOut {
    QString head, detail;  // the detail may be empty
    QColor edge;
    Point at{0.0, 0.0};  // target point [px]
    Point first{0.0, -1.0};  // preferred direction from there
    bool hasFoot = false;  // a dot at the target
};

QSizeF sizeOf(const CallOut& callOut);
void paintCallOut(QPainter& painter, const Theme& theme, const CallOut& callOut, const QRectF& rect);

/// Text over lines, outlined in the casing colour. `at` is on the baseline.
void paintCased(QPainter& painter, const Theme& theme, const QPointF& at, const QString& text, const QColor& colour);

}  // namespace keyblock
