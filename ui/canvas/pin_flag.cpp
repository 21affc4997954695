// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/pin_flag.h"

#include "ui/canvas/call_out.h"
#include "ui/look/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double pole = 22.0, flagHeight = 15.0, leastWidth = 15.0;  // [px]
constexpr int letters = 11;  // [px]

QRectF clothRect(const QPointF& foot, int number) {
    const double text = QFontMetricsF(screenFont(letters, true)).horizontalAdvance(QString::number(number));
    return {std::round(foot.x()), std::round(foot.y() - pole), std::max(leastWidth, std::ceil(text) + 8.0), flagHeight};
}

}  // namespace

QRectF pinFlagRect(const QPointF& foot, int number) {
    return clothRect(foot, number).united(QRectF(foot.x() - 4.0, foot.y() - pole, 8.0, pole + 4.0));
}

void paintPinFlag(QPainter& painter, const Theme& theme, const QPointF& foot, int number) {
    const QRectF cloth = clothRect(foot, number);
    painter.setPen(QPen(theme.markCasing, 3.4));
    painter.drawLine(foot, QPointF(foot.x(), cloth.top()));
    painter.setPen(QPen(theme.accent, 1.6));
    painter.drawLine(foot, QPointF(foot.x(), cloth.top()));
    painter.setPen(QPen(theme.markCasing, 1.2));
    painter.setBrush(theme.accent);
    painter.drawEllipse(foot, 3.0, 3.0);
    painter.drawRoundedRect(cloth.adjusted(-0.6, -0.6, 0.6, 0.6), 2.0, 2.0);
    painter.setFont(screenFont(letters, true));
    painter.setPen(theme.onAccent);
    painter.drawText(cloth, Qt::AlignCenter, QString::number(number));
}

}  // namespace keyblock
