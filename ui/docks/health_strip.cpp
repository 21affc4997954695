// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/health_strip.h"

#include "solver/results/result_names.h"
#include "ui/canvas/call_out.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double top = 8.0, healthRowHeight = 25.0, inset = 12.0;  // [px]
constexpr double valueWidth = 70.0, limitWidth = 86.0, courseWidth = 76.0;  // columns [px]
constexpr double mostName = 190.0;  // [px]

QString small(double value) {
    if (value == 0.0) return QStringLiteral("0");
    if (!std::isfinite(value)) return HealthStrip::tr("not finite");
    if (std::abs(value) >= 0.01) return Display::number(value, 2);
    const QString text = QString::number(value, 'e', 1);  // 2.1e-05
    const int e = text.indexOf('e');
    QString digits = text.left(e).replace('-', QChar(0x2212));
    if (digits.endsWith(".0")) digits.chop(2);
    return digits + QStringLiteral("e−") + QString::number(-text.mid(e + 1).toInt());
}

QString valueText(const HealthRow& row) {
    if (!row.value) return QStringLiteral("–");
    if (!std::isfinite(*row.value)) return small(*row.value);
    if (row.measure == HealthMeasure::Balance) return small(100.0 * *row.value) + QStringLiteral(" %");
    if (row.measure == HealthMeasure::Passes || row.measure == HealthMeasure::StepCuts)
        return Display::number(*row.value, 3);
    return small(*row.value);
}

QString limitText(const HealthRow& row) {
    if (row.measure == HealthMeasure::StepCuts) return HealthStrip::tr("per 100 steps");
    if (row.measure == HealthMeasure::Balance)
        return HealthStrip::tr("limit %1 %").arg(Display::number(100.0 * row.limit, 2));
    if (row.measure == HealthMeasure::Passes) return HealthStrip::tr("limit %1").arg(Display::number(row.limit, 3));
    return HealthStrip::tr("limit %1").arg(small(row.limit));
}

const char* iconOf(HealthState state) {
    switch (state) {
        case HealthState::Good: return "ok";
        case HealthState::Warning: return "warning";
        case HealthState::Bad: return "error";
        case HealthState::Unknown: break;
    }
    return "not-yet";
}

QColor colourOf(HealthState state, const Theme& theme) {
    switch (state) {
        case HealthState::Good: return theme.ok;
        case HealthState::Warning: return theme.warning;
        case HealthState::Bad: return theme.error;
        case HealthState::Unknown: break;
    }
    return theme.text3;
}

}  // namespace

HealthStrip::HealthStrip(const Themes& themes, TimeCursor& cursor, QWidget* parent)
    : QWidget(parent), themes_(themes), cursor_(cursor) {
    setObjectName("health");
    setAccessibleName(tr("Solver diagnostics"));
    setMouseTracking(true);
    connect(&themes, &Themes::changed, this, QOverload<>::of(&QWidget::update));
    connect(&cursor, &TimeCursor::runChanged, this, &HealthStrip::judge);
    connect(&cursor, &TimeCursor::moved, this, &HealthStrip::judge);
    connect(&cursor, &TimeCursor::changed, this, &HealthStrip::judge);
    judge();
}

void HealthStrip::judge() {
    known_ = cursor_.hasMoment();
    if (known_) {
        const FrameHead head = cursor_.head();
        // Samples arrive later than their steps: during a run the newest one is used.
        rows_ = healthAt(*cursor_.run(), head.stage, cursor_.isLive() ? 1e300 : head.time);
    } else {
        rows_ = {};
    }
    update();
}

/// The first of the worst rows, if it is at least a warning.
const HealthRow* HealthStrip::worstRow() const {
    const auto worst = std::max_element(rows_.begin(), rows_.end(),
                                        [](const HealthRow& a, const HealthRow& b) { return a.state < b.state; });
    return worst->state >= HealthState::Warning ? &*worst : nullptr;
}

QString HealthStrip::nameOf(HealthMeasure measure) const {
    switch (measure) {
        case HealthMeasure::Passes:
            return known_ && cursor_.run()->scene().analysis.iteration == Iteration::OpenClose
                       ? tr("Open–close iterations")
                       : tr("Iterations per step");
        case HealthMeasure::StepCuts: return tr("Time-step reductions");
        case HealthMeasure::Penetration: return tr("Penetration / block size");
        case HealthMeasure::Balance: return tr("Energy balance error");
        case HealthMeasure::Residual: break;
    }
    return tr("Unbalanced force ratio");
}

QString HealthStrip::adviceOn(const HealthRow& row) const {
    const QString block = row.block >= 0 && known_
                              ? QString::fromStdString(blockName(cursor_.run()->blockNames(), row.block))
                              : QString();
    if (row.value && !std::isfinite(*row.value))
        return tr("%1: the value is not a finite number, so the results cannot be used. Check the scene for extreme "
                  "values.")
            .arg(nameOf(row.measure));
    switch (row.measure) {
        case HealthMeasure::Passes:
            return tr("Steps need up to %1 iterations; the maximum is %2. Reduce the time step or use more increments.")
                .arg(valueText(row), Display::number(row.limit, 3));
        case HealthMeasure::StepCuts:
            return tr("%1 % of the steps were subdivided. This does not affect the results but slows down the run. "
                      "Reduce the time step or, in a static stage, use more increments.")
                .arg(valueText(row));
        case HealthMeasure::Penetration:
            return tr("%1 penetrates a neighbour by %2 of the size of the smaller block. Increase the penalty ratio, "
                      "or use augmented Lagrangian contacts.")
                .arg(block.isEmpty() ? tr("A block") : tr("Block %1").arg(block), valueText(row));
        case HealthMeasure::Balance:
            return tr("%1 of the energy is unaccounted for. Reduce the time step or the tolerance.")
                .arg(valueText(row));
        case HealthMeasure::Residual: break;
    }
    return tr("The unbalanced force on %1 is %2 times the total force acting on it. Reduce the time step.")
        .arg(block.isEmpty() ? tr("a block") : tr("block %1").arg(block), valueText(row));
}

void HealthStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = themes_.current();
    painter.fillRect(rect(), theme.panel);
    link_ = {};
    if (!known_) {
        painter.setPen(theme.text3);
        painter.drawText(rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Solver diagnostics appear here once a run has started."));
        return;
    }
    double y = top;
    for (const HealthRow& row : rows_) {
        paintRow(painter, row, y);
        y += healthRowHeight;
    }
    if (worstRow()) paintAdvice(painter, y + 6.0);
}

void HealthStrip::paintRow(QPainter& painter, const HealthRow& row, double y) const {
    const Theme& theme = themes_.current();
    const double right = width() - inset;
    const QString icon = iconOf(row.state);
    themes_.icon(icon, colourOf(row.state, theme)).paint(&painter, QRect(int(inset), int(y + 4.5), 16, 16));
    const double limitAt = right - limitWidth, valueAt = limitAt - valueWidth;
    const double nameAt = inset + 24.0, nameEnd = std::min(nameAt + mostName, valueAt - 4.0);
    painter.setPen(theme.text);
    painter.setFont(screenFont(12));
    painter.drawText(QRectF(nameAt, y, nameEnd - nameAt, healthRowHeight), Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(nameOf(row.measure), Qt::ElideRight, int(nameEnd - nameAt)));
    const double courseAt = valueAt - courseWidth;
    if (courseAt > nameAt + 130.0)
        paintCourse(painter, row, QRectF(courseAt, y + 4.0, courseWidth, healthRowHeight - 8.0));
    painter.setPen(theme.text);
    painter.setFont(screenFont(12, true));
    painter.drawText(QRectF(valueAt, y, valueWidth - 8.0, healthRowHeight), Qt::AlignVCenter | Qt::AlignRight,
                     valueText(row));
    painter.setPen(theme.text2);
    painter.setFont(screenFont(11));
    painter.drawText(QRectF(limitAt, y, limitWidth, healthRowHeight), Qt::AlignVCenter | Qt::AlignRight,
                     limitText(row));
}

/// Paints the last values as a line below the dotted limit, with a dot at the newest value.
void HealthStrip::paintCourse(QPainter& painter, const HealthRow& row, const QRectF& box) const {
    const Theme& theme = themes_.current();
    const std::size_t most = static_cast<std::size_t>(box.width());
    const std::size_t from = row.course.size() > most ? row.course.size() - most : 0;
    if (row.course.size() - from < 2) return;
    const double largest = *std::max_element(row.course.begin() + static_cast<long>(from), row.course.end());
    const double high = std::max(largest, row.measure == HealthMeasure::Passes ? row.limit : 1e-300);
    const bool limited = row.limit <= 1.3 * high;
    QPolygonF line;
    for (std::size_t i = from; i < row.course.size(); ++i) {
        const double share = static_cast<double>(i - from) / static_cast<double>(row.course.size() - 1 - from);
        const double part = row.course[i] / (1.05 * high);
        const double up = std::isfinite(part) ? std::clamp(part, 0.0, 1.0) : 1.0;
        line << QPointF(box.left() + share * (box.width() - 4.0), box.bottom() - 2.0 - (box.height() - 4.0) * up);
    }
    if (limited) {
        QPen dotted(theme.text3, 1.0);
        dotted.setDashPattern({2.0, 2.0});
        painter.setPen(dotted);
        const double y = box.bottom() - 2.0 - (box.height() - 4.0) * std::min(1.0, row.limit / (1.05 * high));
        painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    }
    const QColor colour = row.state >= HealthState::Warning ? colourOf(row.state, theme) : theme.text2;
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(line.back(), 2.2, 2.2);
}

void HealthStrip::paintAdvice(QPainter& painter, double y) {
    const Theme& theme = themes_.current();
    const HealthRow& row = *worstRow();
    const bool bad = row.state == HealthState::Bad;
    const QRectF room(inset, y, width() - 2.0 * inset, std::max(20.0, height() - y - 8.0));
    const QString link = row.block >= 0 ? tr("Show block") : QString();
    painter.setFont(screenFont(12, true));
    const double linkWidth = link.isEmpty() ? 0.0 : painter.fontMetrics().horizontalAdvance(link) + 12.0;
    const QRectF text(room.left() + 34.0, room.top() + 8.0, room.width() - 42.0 - linkWidth, 400.0);
    painter.setFont(screenFont(12));
    const QString words = adviceOn(row);
    const QRectF needed = painter.boundingRect(text, Qt::AlignLeft | Qt::TextWordWrap, words);
    const QRectF box(room.left(), room.top(), room.width(), std::min(needed.height() + 16.0, room.height()));
    painter.setPen(QPen(bad ? theme.error : theme.warningFill, 1.0));
    painter.setBrush(bad ? theme.errorSoft : theme.warningSoft);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    themes_.icon(iconOf(row.state), colourOf(row.state, theme))
        .paint(&painter, QRect(int(box.left()) + 10, int(box.top()) + 8, 16, 16));
    painter.setPen(theme.text);
    painter.drawText(text.intersected(box.adjusted(0, 0, 0, -4)), Qt::AlignLeft | Qt::TextWordWrap, words);
    if (link.isEmpty()) return;
    painter.setFont(screenFont(12, true));
    painter.setPen(theme.accent);
    link_ = QRectF(box.right() - linkWidth, box.top() + 8.0, linkWidth, 18.0);
    painter.drawText(link_, Qt::AlignLeft, link);
}

void HealthStrip::mousePressEvent(QMouseEvent* event) {
    const HealthRow* row = known_ ? worstRow() : nullptr;
    if (row && row->block >= 0 && link_.contains(event->localPos()))
        Q_EMIT blockAsked(row->block, nameOf(row->measure) + QStringLiteral(" ") + valueText(*row));
}

void HealthStrip::mouseMoveEvent(QMouseEvent* event) {
    setCursor(link_.contains(event->localPos()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

bool HealthStrip::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || !known_) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const auto index = static_cast<int>(std::floor((help->pos().y() - top) / healthRowHeight));
    if (index >= 0 && index < static_cast<int>(rows_.size()))
        QToolTip::showText(help->globalPos(), nameOf(rows_[static_cast<std::size_t>(index)].measure) + QStringLiteral(": ") +
                                                  valueText(rows_[static_cast<std::size_t>(index)]) + QStringLiteral(", ") +
                                                  limitText(rows_[static_cast<std::size_t>(index)]), this);
    return true;
}

}  // namespace keyblock
