// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/call_out.h"

#include "ui/look/theme.h"

#include <QApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {

namespace {

constexpr double edgeWidth = 3.0, callOutPadding = 8.0, mostCallOutWidth = 240.0;  // [px]
constexpr int headSize = 12, detailSize = 11;  // font sizes [px]

QString fitting(const QString& text, const QFont& font) {
    return QFontMetricsF(font).elidedText(text, Qt::ElideMiddle, mostCallOutWidth);
}

QPointF nearest(const QRectF& rect, const Point& at) {
    return {std::clamp(at.x(), rect.left(), rect.right()), std::clamp(at.y(), rect.top(), rect.bottom())};
}

void paintLeader(QPainter& painter, const Theme& theme, const QPointF& from, const QPointF& to) {
    painter.setPen(QPen(theme.markCasing, 3.0));
    painter.drawLine(from, to);
    painter.setPen(QPen(theme.text2, 1.0));
    painter.drawLine(from, to);
}

}  // namespace

QFont screenFont(int pixels, bool bold) {
    QFont font = QApplication::font();
    font.setPixelSize(pixels);
    if (bold) font.setWeight(QFont::DemiBold);
    return font;
}

void paintPanel(QPainter& painter, const Theme& theme, const QRectF& rect) {
    painter.setPen(QPen(theme.border, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

QSizeF sizeOf(const CallOut& callOut) {
    const QFont head = screenFont(headSize, true), detail = screenFont(detailSize);
    const double width = std::max(QFontMetricsF(head).horizontalAdvance(fitting(callOut.head, head)),
                                  QFontMetricsF(detail).horizontalAdvance(fitting(callOut.detail, detail)));
    return {std::ceil(width + edgeWidth + 2.0 * callOutPadding), callOut.detail.isEmpty() ? 22.0 : 36.0};
}

void paintCallOut(QPainter& painter, const Theme& theme, const CallOut& callOut, const QRectF& rect) {
    const QRectF box(std::round(rect.left()), std::round(rect.top()), rect.width(), rect.height());
    paintLeader(painter, theme, {callOut.at.x(), callOut.at.y()}, nearest(box, callOut.at));
    if (callOut.hasFoot) {
        painter.setPen(QPen(theme.markCasing, 1.2));
        painter.setBrush(theme.text2);
        painter.drawEllipse(QPointF(callOut.at.x(), callOut.at.y()), 2.5, 2.5);
    }
    painter.setPen(QPen(theme.border, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
    painter.fillRect(QRectF(box.left(), box.top(), edgeWidth, box.height()), callOut.edge);
    const QRectF inner = box.adjusted(edgeWidth + callOutPadding, 3.0, -2.0, -3.0);
    const QFont head = screenFont(headSize, true), detail = screenFont(detailSize);
    painter.setFont(head);
    painter.setPen(theme.text);
    painter.drawText(QRectF(inner.topLeft(), QSizeF(inner.width(), 16.0)), Qt::AlignVCenter, fitting(callOut.head, head));
    painter.setFont(detail);
    painter.setPen(theme.text2);
    painter.drawText(QRectF(inner.left(), inner.top() + 15.0, inner.width(), 15.0), Qt::AlignVCenter,
                     fitting(callOut.detail, detail));
}

void paintCased(QPainter& painter, const Theme& theme, const QPointF& at, const QString& text, const QColor& colour) {
    const QPointF start(std::round(at.x()), std::round(at.y()));
    painter.setPen(theme.markCasing);
    for (const auto& [x, y] : {std::pair(-1.0, -1.0), std::pair(0.0, -1.5), std::pair(1.0, -1.0), std::pair(1.5, 0.0),
                               std::pair(1.0, 1.0), std::pair(0.0, 1.5), std::pair(-1.0, 1.0), std::pair(-1.5, 0.0)})
        painter.drawText(start + QPointF(x, y), text);
    painter.setPen(colour);
    painter.drawText(start, text);
}

}  // namespace keyblock
