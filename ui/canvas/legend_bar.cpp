// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/legend_bar.h"

#include "ui/canvas/call_out.h"
#include "ui/canvas/view_theme.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/picture/section/tick_labels.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double barTitleRow = 22.0, limitRow = 15.0, barHeight = 11.0, tickRow = 19.0, barNoteRow = 15.0;  // [px]
constexpr double openerRoom = 13.0, tip = 8.0;  // [px]
constexpr int tickSize = 11, barNoteSize = 11;  // font sizes [px]

struct BarTexts {
    Q_DECLARE_TR_FUNCTIONS(Legend)
};
double widthOf(const QString& word, int size) { return QFontMetricsF(screenFont(size)).horizontalAdvance(word); }

/// Text that describes the range of the colours.
QString scaleText(const LegendBar& bar) {
    const QString clipped = bar.clips() ? BarTexts::tr(" (extreme 2 % clipped)") : QString();
    switch (bar.scale.of) {
        case ScaleOf::AllFrames: return BarTexts::tr("Same scale in all frames") + clipped;
        case ScaleOf::ThisFrame: return BarTexts::tr("Scale of this frame") + clipped;
        case ScaleOf::Own: return BarTexts::tr("Range set manually");
    }
    return {};
}

/// Notes below the bar: the range of this frame, with the sign convention on the same line if both fit.
QStringList notesOf(const LegendBar& bar, double width) {
    QStringList notes;
    const bool large = std::max(std::abs(bar.range.low), std::abs(bar.range.high)) >= 1e4;
    const int decimals = large ? 0 : bar.ticks.decimals + 1;
    if (bar.now)
        notes << BarTexts::tr("This frame: %1 to %2")
                     .arg(qt(numberText(bar.now->low, decimals)), qt(numberText(bar.now->high, decimals)));
    if (const QString convention = qt(bar.convention); !convention.isEmpty()) {
        const QString joined = notes.isEmpty() ? convention : notes.last() + " · " + convention;
        if (!notes.isEmpty() && widthOf(joined, barNoteSize) <= width) notes.last() = joined;
        else notes << convention;
    }
    if (bar.dashed == "compression") notes << BarTexts::tr("Dashed: compression");
    else if (!bar.dashed.empty()) notes << BarTexts::tr("Dashed: negative");
    return notes << scaleText(bar);
}

/// Outline of the bar. It has a triangle at each end beyond which there are values.
QPolygonF outlineOf(const LegendBar& bar, const QPointF& at, double from, double to) {
    QPolygonF outline;
    outline << at + QPointF(from, 0.0) << at + QPointF(to, 0.0);
    if (bar.goesAbove) outline << at + QPointF(to + tip, 0.5 * barHeight);
    outline << at + QPointF(to, barHeight) << at + QPointF(from, barHeight);
    if (bar.goesBelow) outline << at + QPointF(from - tip, 0.5 * barHeight);
    return outline;
}

/// Paints a small arrow; a click on it opens the scale settings. \param end right end of the arrow, at half its height
void paintOpener(QPainter& painter, const Theme& theme, const QPointF& end) {
    painter.save();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.text3);
    const QVector<QPointF> corners{end + QPointF(-8.0, -2.0), end + QPointF(0.0, -2.0), end + QPointF(-4.0, 2.5)};
    painter.drawPolygon(QPolygonF(corners));
    painter.restore();
}

void fillBar(QPainter& painter, const Theme& theme, const LegendBar& bar, const QPointF& at, double from, double to) {
    QLinearGradient gradient(at.x() + from, 0.0, at.x() + to, 0.0);
    QGradientStops stops;
    for (const auto& [share, colour] : bar.stops(theme.dark)) stops.append({share, qtColour(colour)});
    gradient.setStops(stops);
    painter.setPen(QPen(theme.border, 1.0));
    painter.setBrush(gradient);
    painter.drawPolygon(outlineOf(bar, at, from, to).translated(0.5, 0.5));
}

struct LimitLabel {
    QString text;
    double place = 0.0, left = 0.0;  // x of its tick, and left edge of the text [px]
};

/// Moves overlapping labels apart, to the right and then back from the end of the bar. \return true if each label is
/// still over its tick.
bool spread(std::vector<LimitLabel>& labels, double width) {
    double free = 0.0;
    for (LimitLabel& label : labels) {
        const double wide = widthOf(label.text, tickSize);
        label.left = std::max(free, label.place - 0.5 * wide);
        free = label.left + wide + 6.0;
    }
    double end = width;
    for (auto label = labels.rbegin(); label != labels.rend(); ++label) {
        const double wide = widthOf(label->text, tickSize);
        label->left = std::min(label->left, end - wide);
        end = label->left - 6.0;
    }
    return std::all_of(labels.begin(), labels.end(), [](const LimitLabel& label) {
        return label.left >= 0.0 && label.left <= label.place + 2.0 &&
               label.place <= label.left + widthOf(label.text, tickSize) + 2.0;
    });
}

/// Labels of the limits. If they do not all fit with their names, the last ones are shown as numbers only; if that is
/// not enough, the last ones are omitted.
std::vector<LimitLabel> limitLabels(const LegendBar& bar, double from, double to, double width) {
    std::vector<std::pair<double, std::string>> limits = bar.limits;
    std::sort(limits.begin(), limits.end(), [&](const auto& a, const auto& b) {
        return bar.shareOf(a.first) < bar.shareOf(b.first);
    });
    for (std::size_t shown = limits.size(); shown > 0; --shown)
        for (std::size_t named = shown + 1; named-- > 0;) {
            std::vector<LimitLabel> labels;
            for (std::size_t i = 0; i < shown; ++i) {
                const QString number = qt(numberText(limits[i].first));
                labels.push_back({i < named ? qt(limits[i].second) + ' ' + number : number,
                                  from + (to - from) * bar.shareOf(limits[i].first), 0.0});
            }
            if (spread(labels, width)) return labels;
        }
    return {};
}

void paintLimits(QPainter& painter, const Theme& theme, const LegendBar& bar, const QPointF& at, double from, double to,
                 double width) {
    for (const auto& [value, name] : bar.limits)
        painter.fillRect(QRectF(std::round(at.x() + from + (to - from) * bar.shareOf(value)) - 1.0, at.y() - 3.0, 2.0,
                                barHeight + 3.0),
                         theme.text);
    painter.setFont(screenFont(tickSize));
    painter.setPen(theme.text2);
    for (const LimitLabel& label : limitLabels(bar, from, to, width))
        painter.drawText(QPointF(at.x() + label.left, at.y() - 6.0), label.text);
}

}  // namespace

double legendBarHeight(const LegendBar& bar, double width) {
    return barTitleRow + (bar.limits.empty() ? 0.0 : limitRow) + barHeight + tickRow +
           barNoteRow * static_cast<double>(notesOf(bar, width).size());
}

void paintLegendBar(QPainter& painter, const Theme& theme, const LegendBar& bar, const QPointF& at, double width) {
    const QFont bold = screenFont(12, true), plain = screenFont(11);
    const QString unit = qt(bar.unit);
    painter.setFont(plain);
    painter.setPen(theme.text2);
    painter.drawText(QRectF(at, QSizeF(width - openerRoom, 16.0)), Qt::AlignVCenter | Qt::AlignRight, unit);
    paintOpener(painter, theme, at + QPointF(width, 8.0));
    painter.setFont(bold);
    painter.setPen(theme.text);
    const double room = width - widthOf(unit, 11) - 8.0 - openerRoom;
    painter.drawText(QRectF(at, QSizeF(width, 16.0)), Qt::AlignVCenter,
                     QFontMetricsF(bold).elidedText(qt(bar.title), Qt::ElideRight, room));
    const QPointF top(std::round(at.x()), std::round(at.y() + barTitleRow + (bar.limits.empty() ? 0.0 : limitRow)));
    const double from = bar.goesBelow ? tip : 0.0, to = width - (bar.goesAbove ? tip : 0.0);
    fillBar(painter, theme, bar, top, from, to);
    paintLimits(painter, theme, bar, top, from, to, width);
    painter.setFont(screenFont(tickSize));
    const auto labelWidth = [](const std::string& label) { return widthOf(qt(label), tickSize); };
    for (const TickLabel& tick : tickLabels(bar, {from, to, width, 4.0, labelWidth})) {
        painter.fillRect(QRectF(std::round(top.x() + tick.place), top.y() + barHeight, 1.0, 3.0), theme.text3);
        painter.setPen(theme.text2);
        painter.drawText(QPointF(top.x() + tick.middle - 0.5 * labelWidth(tick.text), top.y() + barHeight + 14.0),
                         qt(tick.text));
    }
    painter.setFont(screenFont(barNoteSize));
    QRectF row(top + QPointF(0.0, barHeight + tickRow), QSizeF(width, barNoteRow));
    for (const QString& note : notesOf(bar, width)) {
        painter.drawText(row, Qt::AlignVCenter,
                         QFontMetricsF(painter.font()).elidedText(note, Qt::ElideRight, width));
        row.translate(0.0, barNoteRow);
    }
}

}  // namespace keyblock
