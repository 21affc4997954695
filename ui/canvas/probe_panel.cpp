// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/probe_panel.h"

#include "ui/canvas/call_out.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/picture/section/probe.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double probePadding = 9.0, headRow = 18.0, row = 16.0, gap = 14.0, off = 16.0,
                 mostProbeWidth = 280.0;  // [px]

}  // namespace

void paintProbePanel(QPainter& painter, const Theme& theme, const ProbeReading& reading, const QPointF& mouse,
                     const QSizeF& size) {
    const QFont bold = screenFont(12, true), plain = screenFont(11);
    const QFontMetricsF metrics(plain);
    double left = 0.0, right = 0.0;
    for (const auto& [what, value] : reading.rows) {
        left = std::max(left, metrics.horizontalAdvance(qt(what)));
        right = std::max(right, metrics.horizontalAdvance(qt(value)));
    }
    const double needed = std::max(left + gap + right, QFontMetricsF(bold).horizontalAdvance(qt(reading.head)));
    const double width = std::ceil(std::min(mostProbeWidth, needed) + 2.0 * probePadding);
    const double height = headRow + row * static_cast<double>(reading.rows.size()) + 12.0;
    const double x = mouse.x() + off + width > size.width() ? mouse.x() - off - width : mouse.x() + off;
    const double y = mouse.y() + off + height > size.height() ? mouse.y() - off - height : mouse.y() + off;
    const QRectF panel(std::round(std::max(0.0, x)), std::round(std::max(0.0, y)), width, height);
    paintPanel(painter, theme, panel);
    QRectF line(panel.left() + probePadding, panel.top() + 6.0, width - 2.0 * probePadding, headRow);
    painter.setFont(bold);
    painter.setPen(theme.text);
    painter.drawText(line, Qt::AlignVCenter,
                     QFontMetricsF(bold).elidedText(qt(reading.head), Qt::ElideMiddle, line.width()));
    line = QRectF(line.left(), line.bottom(), line.width(), row);
    painter.setFont(plain);
    for (const auto& [what, value] : reading.rows) {
        painter.setPen(theme.text2);
        painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft, qt(what));
        painter.setPen(theme.text);
        painter.drawText(line, Qt::AlignVCenter | Qt::AlignRight, qt(value));
        line.translate(0.0, row);
    }
}

}  // namespace keyblock
