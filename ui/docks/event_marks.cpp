// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/event_marks.h"

#include "ui/look/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPolygonF>

namespace keyblock {

namespace {

class MarkPainter {
public:
    MarkPainter(QPainter& painter, const Theme& theme, const QPointF& at)
        : painter_(painter), theme_(theme), at_(at) {
        painter_.save();
        painter_.setRenderHint(QPainter::Antialiasing);
    }
    ~MarkPainter() { painter_.restore(); }
    MarkPainter(const MarkPainter&) = delete;
    MarkPainter& operator=(const MarkPainter&) = delete;

    void slip() {
        stroke(theme_.text2, 1.4);
        lines({{-5.0, -2.2}, {4.0, -2.2}, {1.2, -4.6}});
        lines({{5.0, 2.2}, {-4.0, 2.2}, {-1.2, 4.6}});
    }
    void debonding() {
        fill(theme_.slipping, theme_.markInk);
        painter_.drawPolygon(moved({{0.0, -4.8}, {4.8, 0.0}, {0.0, 4.8}, {-4.8, 0.0}}));
    }
    void yield() {
        fill(theme_.yielded, theme_.panel);
        painter_.drawRect(QRectF(at_ - QPointF(3.5, 3.5), QSizeF(7.0, 7.0)));
    }
    void rupture() {
        stroke(theme_.error, 1.8);
        lines({{-1.8, -5.0}, {-4.8, 0.0}, {-1.8, 5.0}});
        lines({{1.8, -5.0}, {4.8, 0.0}, {1.8, 5.0}});
    }
    void plate() {
        stroke(theme_.markInk, 1.2);
        painter_.drawRect(QRectF(at_ - QPointF(5.5, 2.4), QSizeF(11.0, 4.8)));
        stroke(theme_.error, 1.8);
        lines({{-6.0, 4.2}, {6.0, -4.2}});
    }
    void pulledOut() {
        stroke(theme_.error, 1.8);
        lines({{0.0, 5.0}, {0.0, -4.6}});
        lines({{-3.6, -1.2}, {0.0, -4.8}, {3.6, -1.2}});
    }
    void falls() {
        fill(theme_.error, theme_.panel);
        painter_.drawPolygon(moved({{-4.8, -3.8}, {4.8, -3.8}, {0.0, 4.6}}));
    }

private:
    void stroke(const QColor& colour, double width) {
        painter_.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter_.setBrush(Qt::NoBrush);
    }
    void fill(const QColor& inside, const QColor& rim) {
        painter_.setPen(QPen(rim, 1.0));
        painter_.setBrush(inside);
    }
    QPolygonF moved(const QVector<QPointF>& points) const { return QPolygonF(points).translated(at_); }
    void lines(const QVector<QPointF>& points) { painter_.drawPolyline(moved(points)); }

    QPainter& painter_;
    const Theme& theme_;
    QPointF at_;
};

}  // namespace

EventGroup groupOf(EventKind kind) {
    switch (kind) {
        case EventKind::JointSlip:
        case EventKind::JointOpen: return EventGroup::Slip;
        case EventKind::Debonding:
        case EventKind::Restick: return EventGroup::Debonding;
        case EventKind::Yield:
        case EventKind::Hinge: return EventGroup::Yield;
        case EventKind::TensileRupture:
        case EventKind::ShearRupture:
        case EventKind::BoltLoss: return EventGroup::Rupture;
        case EventKind::PlateLoss: return EventGroup::Plate;
        case EventKind::PulledOut: return EventGroup::PulledOut;
        case EventKind::BlockFalls:
        case EventKind::Collapse: break;
    }
    return EventGroup::Falls;
}

std::array<EventKind, 3> kindsOf(EventGroup group) {
    using enum EventKind;
    switch (group) {
        case EventGroup::Slip: return {JointSlip, JointOpen, JointOpen};
        case EventGroup::Debonding: return {Debonding, Restick, Restick};
        case EventGroup::Yield: return {Yield, Hinge, Hinge};
        case EventGroup::Rupture: return {TensileRupture, ShearRupture, BoltLoss};
        case EventGroup::Plate: return {PlateLoss, PlateLoss, PlateLoss};
        case EventGroup::PulledOut: return {PulledOut, PulledOut, PulledOut};
        case EventGroup::Falls: break;
    }
    return {BlockFalls, Collapse, Collapse};
}

QString nameOf(EventGroup group) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("EventGroup", text); };
    switch (group) {
        case EventGroup::Slip: return tr("slip");
        case EventGroup::Debonding: return tr("debonding");
        case EventGroup::Yield: return tr("yield");
        case EventGroup::Rupture: return tr("rupture");
        case EventGroup::Plate: return tr("plate");
        case EventGroup::PulledOut: return tr("pulled out");
        case EventGroup::Falls: break;
    }
    return tr("block falls");
}

void drawEventMark(QPainter& painter, const Theme& theme, EventGroup group, const QPointF& at) {
    MarkPainter mark(painter, theme, at);
    switch (group) {
        case EventGroup::Slip: return mark.slip();
        case EventGroup::Debonding: return mark.debonding();
        case EventGroup::Yield: return mark.yield();
        case EventGroup::Rupture: return mark.rupture();
        case EventGroup::Plate: return mark.plate();
        case EventGroup::PulledOut: return mark.pulledOut();
        case EventGroup::Falls: return mark.falls();
    }
}

}  // namespace keyblock
