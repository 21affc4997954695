// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/scale_bar.h"

#include "ui/canvas/call_out.h"
#include "ui/canvas/canvas_map.h"
#include "ui/look/theme.h"
#include "ui/picture/ticks.h"

#include <QFontMetricsF>
#include <QPainter>

#include <cmath>

namespace keyblock {

namespace {

constexpr double leastLength = 58.0, height = 36.0, scaleInset = 12.0, scalePadding = 9.0, thickness = 5.0;  // [px]

QString label(double shown) { return QString::fromStdString(numberText(shown)); }

/// The length of the scale bar, which is a round number that suits the scale.
struct BarMeasure {
    double pixels = 0.0;
    QString middle, last;
    double half = 0.0;  // [px] half the width of the last number without its unit

    explicit BarMeasure(const CanvasMap& map) {
        const double metres = roundHalvable(leastLength / map.pixelsPerMetre());
        const bool inMetres = metres >= 0.5;
        const double shown = inMetres ? metres : 1e3 * metres;
        pixels = std::round(metres * map.pixelsPerMetre());
        middle = label(0.5 * shown);
        last = label(shown) + (inMetres ? " m" : " mm");
        half = 0.5 * QFontMetricsF(screenFont(12)).horizontalAdvance(label(shown));
    }
};

/// Paints a bar of four pieces, one of them hollow.
void paintBar(QPainter& painter, const Theme& theme, const QPointF& at, double length) {
    painter.setPen(QPen(theme.text, 1.0));
    for (int i = 0; i < 4; ++i) {
        painter.setBrush(i == 1 ? theme.panel : theme.text);
        painter.drawRect(QRectF(at.x() + 0.25 * i * length, at.y(), 0.25 * length, thickness));
    }
}

}  // namespace

QRectF scaleBarRect(const CanvasMap& map) {
    const BarMeasure measure(map);
    const double last = QFontMetricsF(screenFont(12)).horizontalAdvance(measure.last) - measure.half;
    return {scaleInset, std::round(map.size().height() - scaleInset - height),
            std::ceil(2.0 * scalePadding + measure.pixels + last + 4.0), height};
}

void paintScaleBar(QPainter& painter, const Theme& theme, const CanvasMap& map) {
    const BarMeasure measure(map);
    const QRectF panel = scaleBarRect(map);
    paintPanel(painter, theme, panel);
    const QPointF at(panel.left() + scalePadding + 2.5, panel.bottom() - 13.5);
    paintBar(painter, theme, at, measure.pixels);
    painter.setFont(screenFont(12));
    painter.setPen(theme.text);
    const QFontMetricsF metrics(painter.font());
    const double line = at.y() - 5.0;
    painter.drawText(QPointF(at.x() - 0.5 * metrics.horizontalAdvance("0"), line), "0");
    painter.drawText(QPointF(at.x() + 0.5 * (measure.pixels - metrics.horizontalAdvance(measure.middle)), line),
                     measure.middle);
    painter.drawText(QPointF(at.x() + measure.pixels - measure.half, line), measure.last);
}

}  // namespace keyblock
