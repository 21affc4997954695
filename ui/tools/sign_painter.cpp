// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/sign_painter.h"

#include "ui/canvas/canvas_map.h"
#include "ui/edit/locate.h"
#include "ui/look/theme.h"

#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double signSpacing = 22.0, tick = 7.0, arrowLength = 34.0, mostName = 150.0, nameGap = 11.0;  // [px]
constexpr double leastForNames = 15.0;  // [px/m] at smaller scales, names would overlap bolts

template <typename Item>
const Item* itemAt(const Scene& scene, const std::string& pointer) {
    const auto place = locate(scene, pointer);
    return place && place->isObject() ? static_cast<const Item*>(place->object()) : nullptr;
}

/// Clips a line to its visible part, which limits the number of signs. False if nothing is visible.
bool clip(QLineF& line, const QRectF& room) {
    double begin = 0.0, end = 1.0;
    const QPointF way = line.p2() - line.p1();
    const auto cut = [&](double from, double step, double least, double most) {
        if (step == 0.0) return from >= least && from <= most;
        const double a = (least - from) / step, b = (most - from) / step;
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
        return begin < end;
    };
    if (!cut(line.x1(), way.x(), room.left(), room.right())) return false;
    if (!cut(line.y1(), way.y(), room.top(), room.bottom())) return false;
    line = QLineF(line.pointAt(begin), line.pointAt(end));
    return true;
}

QRectF around(const QPointF& centre, const QSizeF& size) {
    return {centre - 0.5 * QPointF(size.width(), size.height()), size};
}

}  // namespace

SignPainter::SignPainter(QPainter& painter, const CanvasMap& map, const Theme& theme)
    : painter_(painter), map_(map), theme_(theme) {}

void SignPainter::paint(const Scene& scene, const SceneObject& object) {
    const QColor& colour = theme_.text2;
    switch (object.kind) {
        case ObjectKind::Support:
            if (const auto* found = itemAt<Support>(scene, object.pointer)) support(*found, object);
            break;
        case ObjectKind::Load:
            if (const auto* found = itemAt<Load>(scene, object.pointer)) load(*found);
            break;
        case ObjectKind::Motion:
            if (const auto* found = itemAt<Motion>(scene, object.pointer)) motion(found->blockAt, found->axis, colour);
            break;
        case ObjectKind::Velocity:
            if (const auto* found = itemAt<InitialVelocity>(scene, object.pointer))
                arrow(found->blockAt, found->velocity, arrowLength, colour);
            break;
        case ObjectKind::Monitor:
            if (const auto* found = itemAt<Monitor>(scene, object.pointer))
                for (const Point& mark : object.marks) monitor(mark, QString::fromStdString(found->name), colour);
            break;
        default: break;
    }
}

void SignPainter::support(const Support& support, const SceneObject& object) {
    for (const ObjectLine& line : object.lines) side(line.points.front(), line.points.back(), support.fix, theme_.text2);
    for (const Point& mark : object.marks) held(mark, support.fix, theme_.text2);
}

void SignPainter::side(const Point& from, const Point& to, Fix fix, const QColor& colour) {
    QLineF line(map_.toPixel(from), map_.toPixel(to));
    if (!clip(line, QRectF(QPointF(), map_.size()).adjusted(-20, -20, 20, 20)) || line.length() < 2.0) return;
    const QPointF along = (line.p2() - line.p1()) / line.length(), out(-along.y(), along.x());
    painter_.setPen(QPen(colour, 1.0));
    painter_.setBrush(Qt::NoBrush);
    const bool level = std::abs(along.x()) > std::abs(along.y());
    const bool rolls = (fix == Fix::X && !level) || (fix == Fix::Y && level);
    const int count = std::clamp(static_cast<int>(line.length() / signSpacing), 1, 400);
    for (int i = 0; i < count; ++i) {
        const QPointF at = line.pointAt((i + 0.5) / count);
        if (rolls)
            painter_.drawEllipse(at + 4.0 * out, 3.0, 3.0);
        else
            painter_.drawLine(at, at + tick * out - tick * along);
    }
    if (rolls) painter_.drawLine(line.translated(8.0 * out));
}

void SignPainter::held(const Point& place, Fix fix, const QColor& colour) {
    const QPointF at = map_.toPixel(place);
    painter_.setPen(QPen(colour, 1.4));
    painter_.setBrush(theme_.panel);
    if (fix == Fix::All) {
        painter_.drawRect(QRectF(at.x() - 5.0, at.y() - 5.0, 10.0, 10.0));
        painter_.drawLine(at + QPointF(-5, -5), at + QPointF(5, 5));
        painter_.drawLine(at + QPointF(-5, 5), at + QPointF(5, -5));
        return;
    }
    painter_.save();
    painter_.translate(at);
    if (fix == Fix::X) painter_.rotate(90.0);
    painter_.drawPolygon(QPolygonF(QVector<QPointF>{{0.0, 0.0}, {7.0, 11.0}, {-7.0, 11.0}}));
    painter_.drawLine(QPointF(-9.0, fix == Fix::XY ? 11.0 : 14.5), QPointF(9.0, fix == Fix::XY ? 11.0 : 14.5));
    painter_.restore();
}

void SignPainter::head(const QPointF& tip, const QPointF& along, const QColor& colour) {
    const QPointF across(-along.y(), along.x());
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawPolygon(QPolygonF(QVector<QPointF>{tip, tip - 8.0 * along + 3.6 * across, tip - 8.0 * along - 3.6 * across}));
}

void SignPainter::arrow(const Point& place, const Point& way, double pixels, const QColor& colour) {
    const double length = way.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return monitor(place, {}, colour);
    const QPointF along(way.x() / length, -way.y() / length), tip = map_.toPixel(place);
    painter_.setPen(QPen(colour, 1.8));
    painter_.drawLine(tip - pixels * along, tip - 6.0 * along);
    head(tip, along, colour);
}

void SignPainter::load(const Load& load) {
    const QColor& colour = theme_.text2;
    if (load.along) return pressure((*load.along)[0], (*load.along)[1], load.pressure < 0.0, colour);
    const auto& place = load.point ? load.point : load.at ? load.at : load.blockAt;
    if (place) arrow(*place, load.force, arrowLength, colour);
}

void SignPainter::pressure(const Point& from, const Point& to, bool pulls, const QColor& colour) {
    QLineF line(map_.toPixel(from), map_.toPixel(to));
    if (!clip(line, QRectF(QPointF(), map_.size()).adjusted(-20, -20, 20, 20)) || line.length() < 2.0) return;
    const QPointF along = (line.p2() - line.p1()) / line.length();
    QPointF into(-along.y(), along.x());
    if (into.y() < 0.0) into = -into;  // arrows are drawn from above; the edges decide which side is loaded
    const int count = std::clamp(static_cast<int>(line.length() / signSpacing), 1, 400);
    painter_.setPen(QPen(colour, 1.2));
    painter_.drawLine(line.translated(-20.0 * into));
    for (int i = 0; i <= count; ++i) {
        const QPointF at = line.pointAt(static_cast<double>(i) / count);
        painter_.setPen(QPen(colour, 1.2));
        painter_.drawLine(at - 20.0 * into, at);
        pulls ? head(at - 20.0 * into, -into, colour) : head(at, into, colour);
    }
}

void SignPainter::motion(const Point& place, const Point& axis, const QColor& colour) {
    const double length = axis.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return;
    const QPointF along(axis.x() / length, -axis.y() / length), at = map_.toPixel(place);
    painter_.setPen(QPen(colour, 1.8));
    painter_.drawLine(at, at + 28.0 * along);
    head(at + 34.0 * along, along, colour);
    painter_.setPen(QPen(colour, 1.4));
    painter_.setBrush(theme_.panel);
    painter_.drawEllipse(at, 4.0, 4.0);
}

void SignPainter::monitor(const Point& place, const QString& name, const QColor& colour) {
    const QPointF at = map_.toPixel(place);
    painter_.setPen(QPen(theme_.panel, 3.4));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawEllipse(at, 4.5, 4.5);
    painter_.setPen(QPen(colour, 1.4));
    painter_.drawEllipse(at, 4.5, 4.5);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter_.drawLine(at + 3.0 * way, at + 8.0 * way);
    taken_.push_back(around(at, {2.0 * tick, 2.0 * tick}));
    if (!name.isEmpty() && map_.pixelsPerMetre() >= leastForNames) names_.push_back({at, name, colour});
}

void SignPainter::paintNames() {
    QFont font = painter_.font();
    font.setPixelSize(11);
    const QFontMetricsF metrics(font);
    for (const Name& name : names_) {
        const QString shown = metrics.elidedText(name.text, Qt::ElideRight, mostName);
        const std::optional<QRectF> box = freeBox(name.at, {metrics.horizontalAdvance(shown), 14.0});
        if (!box) continue;
        QPainterPath letters;
        letters.addText(QPointF(box->left(), box->bottom() - 3.0), font, shown);
        painter_.setPen(QPen(theme_.canvas, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter_.drawPath(letters);
        painter_.fillPath(letters, name.colour);
    }
}

/// A place for a name beside, below or above its symbol, clear of symbols and earlier names; none if there is no room.
std::optional<QRectF> SignPainter::freeBox(const QPointF& at, const QSizeF& size) {
    const double beside = nameGap + 0.5 * size.width(), over = nameGap + 0.5 * size.height();
    for (const QPointF& way : {QPointF(beside, 0.0), QPointF(-beside, 0.0), QPointF(0.0, over), QPointF(0.0, -over)}) {
        const QRectF box = around(at + way, size);
        if (std::ranges::any_of(taken_, [&](const QRectF& other) { return other.intersects(box); })) continue;
        taken_.push_back(box);
        return box;
    }
    return std::nullopt;
}

}  // namespace keyblock
