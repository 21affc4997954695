// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/legend_activity.h"

#include "ui/canvas/call_out.h"
#include "ui/look/theme.h"

#include <QCoreApplication>
#include <QPainter>

#include <array>
#include <optional>

namespace keyblock {

namespace {

struct ActivityTexts {
    Q_DECLARE_TR_FUNCTIONS(Activity)
};

constexpr double activityTitle = 22.0, activityRow = 20.0;  // [px]
constexpr int activityRows = 4;

struct ActivityEntry {
    QString name;
    int count = 0;
    std::optional<BlockActivity> activity;  // none: not drawn
};

}  // namespace

double legendActivityHeight() { return activityTitle + activityRows * activityRow; }

void paintLegendActivity(QPainter& painter, const Theme& theme, const ActivityCounts& counts, const QPointF& at,
                         double width) {
    const std::array<ActivityEntry, activityRows> entries{
        ActivityEntry{ActivityTexts::tr("active"), counts.active, BlockActivity::Active},
        ActivityEntry{ActivityTexts::tr("asleep"), counts.asleep, BlockActivity::Asleep},
        ActivityEntry{ActivityTexts::tr("fixed, no unknowns"), counts.fixed, BlockActivity::Fixed},
        ActivityEntry{ActivityTexts::tr("removed"), counts.removed, std::nullopt}};
    painter.setFont(screenFont(12, true));
    painter.setPen(theme.text);
    painter.drawText(QRectF(at, QSizeF(width, 16.0)), Qt::AlignVCenter, ActivityTexts::tr("Modelled blocks"));
    painter.setFont(screenFont(11));
    QPointF row = at + QPointF(0.0, activityTitle);
    for (const ActivityEntry& entry : entries) {
        const QRectF swatch(row.x() + 1.5, row.y() + 4.5, 15.0, 11.0);
        painter.setPen(QPen(theme.text3, 1.0));
        painter.setBrush(Qt::NoBrush);
        if (entry.activity) {
            const Colour colour = colourOf(*entry.activity, theme.dark);
            painter.setBrush(QColor(colour.red, colour.green, colour.blue));
        }
        painter.drawRect(swatch);
        painter.setPen(theme.text);
        painter.drawText(QRectF(row.x() + 24.0, row.y(), width - 24.0, activityRow), Qt::AlignVCenter, entry.name);
        painter.setPen(theme.text2);
        painter.drawText(QRectF(row.x(), row.y(), width, activityRow), Qt::AlignVCenter | Qt::AlignRight,
                         QString::number(entry.count));
        row.ry() += activityRow;
    }
}

}  // namespace keyblock
