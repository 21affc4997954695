// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/legend_key.h"

#include "ui/canvas/call_out.h"
#include "ui/canvas/screen_marks.h"
#include "ui/look/theme.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <optional>

namespace keyblock {

namespace {

constexpr double keyTitleRow = 22.0, keyRow = 20.0, column = 103.0;  // [px]
constexpr double groupGap = 8.0;  // between points and steel [px]

using Entry = std::optional<MarkKind>;  // none: the marked block

struct Groups {
    std::vector<Entry> points, steel;
};

Groups groupsOf(const std::vector<MarkKind>& kinds, bool highlighted) {
    constexpr std::array ofPoints{MarkKind::Bonded, MarkKind::Artificial, MarkKind::Slipping,
                                  MarkKind::InGap,  MarkKind::Gone,       MarkKind::Yielded};
    constexpr std::array ofSteel{MarkKind::Ruptured, MarkKind::Plate, MarkKind::PlateLost};
    const auto isThere = [&](MarkKind kind) { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); };
    Groups groups;
    std::copy_if(ofPoints.begin(), ofPoints.end(), std::back_inserter(groups.points), isThere);
    std::copy_if(ofSteel.begin(), ofSteel.end(), std::back_inserter(groups.steel), isThere);
    if (highlighted) groups.steel.push_back(std::nullopt);
    return groups;
}

double rowsOf(const std::vector<Entry>& entries) { return static_cast<double>((entries.size() + 1) / 2); }

void paintEntry(QPainter& painter, const Theme& theme, const Entry& entry, const QPointF& at) {
    const QPointF middle = at + QPointF(8.0, 0.5 * keyRow);
    if (entry) {
        const bool lost = *entry == MarkKind::PlateLost;
        const QPointF along = *entry == MarkKind::Plate || lost ? QPointF(0.0, 1.0) : QPointF(1.0, 0.0);
        MarkTheme marks = screenMarks(theme);
        marks.sizes.lostAway = marks.sizes.lostTilt = 0.0;
        paintMark(painter, *entry, middle, along, false, marks);
    } else {
        QPen pen(theme.warningFill, 1.6);
        pen.setDashPattern({2.5, 1.5});
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(middle.x() - 6.5, middle.y() - 4.5, 13.0, 9.0));
    }
    painter.setFont(screenFont(11));
    painter.setPen(theme.text);
    painter.drawText(QRectF(at.x() + 22.0, at.y(), column - 22.0, keyRow), Qt::AlignVCenter,
                     entry ? markName(*entry) : QCoreApplication::translate("Marks", "Marked block"));
}

double paintGroup(QPainter& painter, const Theme& theme, const std::vector<Entry>& entries, const QPointF& at) {
    for (std::size_t i = 0; i < entries.size(); ++i)
        paintEntry(painter, theme, entries[i], at + QPointF(i % 2 ? column : 0.0, keyRow * static_cast<double>(i / 2)));
    return keyRow * rowsOf(entries);
}

}  // namespace

double legendKeyHeight(const std::vector<MarkKind>& kinds, bool highlighted) {
    const Groups groups = groupsOf(kinds, highlighted);
    if (groups.points.empty() && groups.steel.empty()) return 0.0;
    const double gap = groups.points.empty() || groups.steel.empty() ? 0.0 : groupGap;
    return keyTitleRow + keyRow * (rowsOf(groups.points) + rowsOf(groups.steel)) + gap;
}

void paintLegendKey(QPainter& painter, const Theme& theme, const std::vector<MarkKind>& kinds, bool highlighted,
                    const QPointF& at) {
    const Groups groups = groupsOf(kinds, highlighted);
    painter.setFont(screenFont(12, true));
    painter.setPen(theme.text);
    painter.drawText(QRectF(at, QSizeF(2.0 * column, 16.0)), Qt::AlignVCenter,
                     groups.points.empty() ? QCoreApplication::translate("Marks", "Marks")
                                           : QCoreApplication::translate("Marks", "Bolt nodes"));
    QPointF below = at + QPointF(0.0, keyTitleRow);
    below.ry() += paintGroup(painter, theme, groups.points, below);
    if (!groups.points.empty() && !groups.steel.empty()) {
        painter.fillRect(QRectF(below.x(), std::round(below.y() + 0.5 * groupGap), 2.0 * column - 2.0, 1.0),
                         theme.separator);
        below.ry() += groupGap;
    }
    paintGroup(painter, theme, groups.steel, below);
}

}  // namespace keyblock
