// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/event_marks.h"

#include "ui/look/theme.h"

#include <QPainter>
#include <QPolygonF>

#include <string_view>

namespace keyblock {

namespace {

QString shown(std::string_view title) { return QString::fromUtf8(title.data(), static_cast<int>(title.size())); }

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
    void opening() {
        stroke(theme_.text2, 1.4);
        lines({{-5.0, -1.2}, {5.0, -1.2}});
        lines({{-5.0, 1.2}, {5.0, 1.2}});
        lines({{-2.0, -3.2}, {0.0, -5.2}, {2.0, -3.2}});
        lines({{-2.0, 3.2}, {0.0, 5.2}, {2.0, 3.2}});
    }
    void debonding() {
        fill(theme_.slipping, theme_.markInk);
        painter_.drawPolygon(moved({{0.0, -4.8}, {4.8, 0.0}, {0.0, 4.8}, {-4.8, 0.0}}));
    }
    void restick() {
        stroke(theme_.text2, 1.4);
        painter_.drawPolygon(moved({{0.0, -4.4}, {4.4, 0.0}, {0.0, 4.4}, {-4.4, 0.0}}));
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

QString nameOf(EventGroup group) { return shown(rowOf(group).title); }
QString nameOf(EventKind kind) { return shown(rowOf(kind).title); }

void drawEventMark(QPainter& painter, const Theme& theme, EventMark mark, const QPointF& at) {
    MarkPainter ink(painter, theme, at);
    switch (mark) {
        case EventMark::Slip: return ink.slip();
        case EventMark::Opening: return ink.opening();
        case EventMark::Debonding: return ink.debonding();
        case EventMark::Restick: return ink.restick();
        case EventMark::Yield: return ink.yield();
        case EventMark::Rupture: return ink.rupture();
        case EventMark::Plate: return ink.plate();
        case EventMark::PulledOut: return ink.pulledOut();
        case EventMark::Falls: return ink.falls();
    }
}

}  // namespace keyblock
