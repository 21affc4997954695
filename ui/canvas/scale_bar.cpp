// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/scale_bar.h"

#include "ui/canvas/canvas_map.h"
#include "ui/look/theme.h"
#include "ui/picture/ticks.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double leastLength = 58.0, height = 36.0, inset = 12.0, padding = 9.0, thickness = 5.0;  // [px]

QString label(double shown) { return QString::fromStdString(numberText(shown)); }

/// Four pieces, every second one hollow.
void paintBar(QPainter& painter, const Theme& theme, const QPointF& at, double length) {
    painter.setPen(QPen(theme.text, 1.0));
    for (int i = 0; i < 4; ++i) {
        painter.setBrush(i == 1 ? theme.panel : theme.text);
        painter.drawRect(QRectF(at.x() + 0.25 * i * length, at.y(), 0.25 * length, thickness));
    }
}

}  // namespace

QRectF paintScaleBar(QPainter& painter, const Theme& theme, const CanvasMap& map) {
    const double metres = roundHalvable(leastLength / map.pixelsPerMetre()), length = metres * map.pixelsPerMetre();
    const bool inMetres = metres >= 0.5;
    const double shown = inMetres ? metres : 1e3 * metres;
    const QString last = label(shown) + (inMetres ? " m" : " mm");
    QFont font = painter.font();
    font.setPixelSize(12);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const double half = 0.5 * metrics.horizontalAdvance(label(shown));
    const double width = 2.0 * padding + length + metrics.horizontalAdvance(last) - half + 4.0;
    const QRectF panel(inset, std::round(map.size().height() - inset - height), std::ceil(width), height);
    painter.setPen(QPen(theme.separator, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(panel.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    const QPointF at(panel.left() + padding + 2.5, panel.bottom() - 13.5);
    paintBar(painter, theme, at, std::round(length));
    painter.setPen(theme.text);
    const double line = at.y() - 5.0;
    painter.drawText(QPointF(at.x() - 0.5 * metrics.horizontalAdvance("0"), line), "0");
    const QString middle = label(0.5 * shown);
    painter.drawText(QPointF(at.x() + 0.5 * length - 0.5 * metrics.horizontalAdvance(middle), line), middle);
    painter.drawText(QPointF(at.x() + length - half, line), last);
    return panel;
}

}  // namespace keyblock
