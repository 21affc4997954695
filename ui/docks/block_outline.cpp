// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/block_outline.h"

#include "ui/canvas/canvas.h"
#include "ui/canvas/canvas_map.h"
#include "ui/look/theme.h"
#include "ui/picture/section.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace keyblock {

void BlockOutline::paint(QPainter& painter, const CanvasMap& map) const {
    if (block_ < 0 || !canvas_.picture()) return;
    const auto& blocks = canvas_.picture()->blocks;
    const auto shape = std::find_if(blocks.begin(), blocks.end(), [&](const BlockShape& b) { return b.block == block_; });
    if (shape == blocks.end()) return;
    const Theme& theme = themes_.current();
    QPolygonF outline;
    for (const Point& corner : shape->outline) outline << map.toPixel(corner);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = theme.warningFill;
    fill.setAlphaF(0.14);
    QPen dashed(theme.warningFill, 2.0);
    dashed.setDashPattern({2.5, 1.5});
    painter.setPen(dashed);
    painter.setBrush(fill);
    painter.drawPolygon(outline);
    QFont font = painter.font();
    font.setPixelSize(12);
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    const QString name = QString::fromStdString(shape->name);
    const QSizeF size(painter.fontMetrics().horizontalAdvance(name) + 16.0, 20.0);
    const QRectF bounds = outline.boundingRect();
    const QRectF label(QPointF(bounds.center().x() - 0.5 * size.width(), bounds.bottom() + 4.0), size);
    painter.setPen(QPen(theme.border, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(label, 2.0, 2.0);
    painter.fillRect(QRectF(label.left(), label.top(), 3.0, label.height()), theme.warningFill);
    painter.setPen(theme.text);
    painter.drawText(label, Qt::AlignCenter, name);
    painter.restore();
}

}  // namespace keyblock
