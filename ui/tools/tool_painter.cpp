// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_painter.h"

#include "ui/canvas/canvas_map.h"
#include "ui/look/theme.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double snapSize = 14.0, snapLine = 2.2, inset = 12.0;  // [px]
constexpr double betweenReal = 9.0, betweenArtificial = 16.0;  // [px] smallest distances of nodes in a preview

QFont fontOf(const QPainter& painter, int pixels, bool bold = false) {
    QFont font = painter.font();
    font.setPixelSize(pixels);
    font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
    return font;
}

QPen dashed(const QColor& colour, double width) {
    QPen pen(colour, width, Qt::CustomDashLine, Qt::FlatCap, Qt::RoundJoin);
    pen.setDashPattern({7.0 / width, 4.0 / width});
    return pen;
}

QColor faint(QColor colour, double share) {
    colour.setAlphaF(share);
    return colour;
}

/// The mark of a kind of snap, centred at (0, 0); `r` is half its size.
QPainterPath markOf(SnapKind kind, double r) {
    QPainterPath path;
    switch (kind) {
        case SnapKind::End: path.addRect(-r, -r, 2.0 * r, 2.0 * r); break;
        case SnapKind::Intersection:
            path.moveTo(-r, -r), path.lineTo(r, r), path.moveTo(-r, r), path.lineTo(r, -r);
            break;
        case SnapKind::Middle:
            path.addPolygon(QPolygonF(QVector<QPointF>{{0.0, -r}, {r, r}, {-r, r}, {0.0, -r}}));
            break;
        case SnapKind::Foot:
            path.moveTo(-r, -r), path.lineTo(-r, r), path.lineTo(r, r);
            path.moveTo(-r, 0.0), path.lineTo(0.0, 0.0), path.lineTo(0.0, r);
            break;
        case SnapKind::OnLine:
            path.addPolygon(QPolygonF(QVector<QPointF>{{-r, -r}, {r, -r}, {-r, r}, {r, r}, {-r, -r}}));
            break;
        case SnapKind::Grid: path.addEllipse(QPointF(), 0.3 * r, 0.3 * r); break;
    }
    return path;
}

/// Keeps bonded nodes if there is space between them, and then intermediate nodes if there is still more space.
std::vector<NodeAhead> apart(const std::vector<NodeAhead>& nodes, double length) {
    std::vector<NodeAhead> kept;
    for (const bool real : {true, false})
        for (const NodeAhead& node : nodes) {
            const double room = real ? betweenReal : betweenArtificial;
            const bool isFree = std::none_of(kept.begin(), kept.end(), [&](const NodeAhead& other) {
                return std::abs(other.share - node.share) * length < room;
            });
            if (node.real == real && isFree) kept.push_back(node);
        }
    return kept;
}

}  // namespace

ToolPainter::ToolPainter(QPainter& painter, const CanvasMap& map, const Theme& theme)
    : painter_(painter), map_(map), theme_(theme) {
    painter_.setRenderHint(QPainter::Antialiasing);
}

QPolygonF ToolPainter::pixels(const std::vector<Point>& points) const {
    // Larger coordinates overflow the painter's integers, and nothing so far away is visible.
    constexpr double farthest = 1e6;
    QPolygonF polygon;
    for (const Point& point : points) {
        const QPointF pixel = map_.toPixel(point);
        polygon << QPointF(std::clamp(pixel.x(), -farthest, farthest), std::clamp(pixel.y(), -farthest, farthest));
    }
    return polygon;
}

void ToolPainter::ghost(const std::vector<Point>& points, bool closed, double width) {
    painter_.setPen(dashed(theme_.accent, width));
    painter_.setBrush(Qt::NoBrush);
    closed ? painter_.drawPolygon(pixels(points)) : painter_.drawPolyline(pixels(points));
}

void ToolPainter::ghostFill(const std::vector<Point>& outline) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(faint(theme_.accent, 0.08));
    painter_.drawPolygon(pixels(outline));
}

void ToolPainter::chosen(const std::vector<Point>& points, bool closed, double width) {
    painter_.setPen(QPen(theme_.accent, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    closed ? painter_.drawPolygon(pixels(points)) : painter_.drawPolyline(pixels(points));
}

void ToolPainter::near(const std::vector<Point>& points, bool closed) {
    painter_.setPen(QPen(faint(theme_.accent, 0.45), 4.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    closed ? painter_.drawPolygon(pixels(points)) : painter_.drawPolyline(pixels(points));
}

void ToolPainter::wall(const std::vector<Point>& points) {
    painter_.setPen(QPen(theme_.accent, 3.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(pixels(points));
}

void ToolPainter::bolt(const Point& head, const Point& farEnd, bool plate, const std::vector<NodeAhead>& nodes) {
    const QLineF shank(map_.toPixel(head), map_.toPixel(farEnd));
    painter_.setPen(dashed(theme_.accent, 2.0));
    painter_.drawLine(shank);
    if (!(shank.length() > 1.0)) return;
    const QPointF along = (shank.p2() - shank.p1()) / shank.length(), across(-along.y(), along.x());
    painter_.setPen(QPen(theme_.accent, 1.4));
    for (const NodeAhead& node : apart(nodes, shank.length())) {
        painter_.setBrush(node.real ? theme_.accent : theme_.panel);
        const double r = node.real ? 3.3 : 2.7;
        painter_.drawEllipse(shank.pointAt(1.0 - node.share), r, r);
    }
    if (!plate) return;
    painter_.setBrush(theme_.panel);
    painter_.drawPolygon(QPolygonF(QVector<QPointF>{shank.p1() - 7.0 * across, shank.p1() + 7.0 * across,
                                   shank.p1() + 7.0 * across - 5.0 * along, shank.p1() - 7.0 * across - 5.0 * along}));
}

void ToolPainter::corner(const Point& place) {
    const QPointF at = map_.toPixel(place);
    painter_.setPen(QPen(theme_.accent, 1.4));
    painter_.setBrush(theme_.panel);
    painter_.drawRect(QRectF(at.x() - 3.5, at.y() - 3.5, 7.0, 7.0));
}

void ToolPainter::handle(const Point& place, bool hot) {
    const QPointF at = map_.toPixel(place);
    const double r = hot ? 5.5 : 4.5;
    painter_.setPen(QPen(theme_.accent, 1.6));
    painter_.setBrush(hot ? theme_.accent : theme_.panel);
    painter_.drawRect(QRectF(at.x() - r, at.y() - r, 2.0 * r, 2.0 * r));
}

void ToolPainter::dot(const Point& place) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(theme_.accent);
    painter_.drawEllipse(map_.toPixel(place), 3.5, 3.5);
}

void ToolPainter::dimension(const Point& from, const Point& to, const QString& text, double off) {
    const QPointF a = map_.toPixel(from), b = map_.toPixel(to);
    const double length = QLineF(a, b).length();
    if (!(length > 1.0)) return;
    const QPointF along = (b - a) / length, left(along.y(), -along.x());
    const QPointF p = a + off * left, q = b + off * left;
    painter_.setPen(QPen(theme_.text2, 1.0));
    painter_.drawLine(p, q);
    for (const auto& [end, foot] : {std::pair{p, a}, std::pair{q, b}}) {
        painter_.drawLine(foot + (off > 0 ? 2.0 : -2.0) * left, end + (off > 0 ? 4.0 : -4.0) * left);
        painter_.setBrush(theme_.text2);
        painter_.drawEllipse(end, 1.8, 1.8);
    }
    label(0.5 * (p + q), text);
}

void ToolPainter::label(const QPointF& at, const QString& text) {
    painter_.setFont(fontOf(painter_, 11));
    const QFontMetricsF metrics(painter_.font());
    const QRectF box(at.x() - 0.5 * metrics.horizontalAdvance(text) - 6.0, at.y() - 8.5,
                     metrics.horizontalAdvance(text) + 12.0, 17.0);
    painter_.setPen(QPen(theme_.separator, 1.0));
    painter_.setBrush(theme_.panel);
    painter_.drawRoundedRect(box, 3.0, 3.0);
    painter_.setPen(theme_.text);
    painter_.drawText(box, Qt::AlignCenter, text);
}

void ToolPainter::snap(const Snap& snap) {
    const QPointF at = map_.toPixel(snap.place);
    const QPainterPath mark = markOf(snap.kind, 0.5 * (snapSize - snapLine));
    painter_.save();
    painter_.translate(at);
    painter_.setBrush(snap.kind == SnapKind::Grid ? QBrush(theme_.accent) : QBrush(Qt::NoBrush));
    painter_.setPen(QPen(theme_.panel, snapLine + 2.4));
    painter_.drawPath(mark);
    painter_.setPen(QPen(theme_.accent, snapLine));
    painter_.drawPath(mark);
    painter_.restore();
    if (snap.kind == SnapKind::Grid) return;
    painter_.setFont(fontOf(painter_, 12, true));
    const QString name = QString::fromStdString(snap.name);
    const double width = QFontMetricsF(painter_.font()).horizontalAdvance(name) + 34.0;
    QRectF tag(at.x() + 34.0, at.y() + 20.0, width, 22.0);
    if (tag.right() > map_.size().width() - 4.0) tag.moveRight(at.x() - 20.0);
    if (tag.bottom() > map_.size().height() - 4.0) tag.moveBottom(at.y() - 20.0);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(theme_.markInk);
    painter_.drawRoundedRect(tag, 3.0, 3.0);
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(theme_.markCasing, 1.6));
    painter_.translate(tag.left() + 14.0, tag.center().y());
    painter_.drawPath(markOf(snap.kind, 4.0));
    painter_.translate(-tag.left() - 14.0, -tag.center().y());
    painter_.drawText(tag.adjusted(26.0, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, name);
}

void ToolPainter::box(const QRectF& box, bool crosses) {
    painter_.setPen(crosses ? dashed(theme_.accent, 1.2) : QPen(theme_.accent, 1.2));
    painter_.setBrush(faint(theme_.accent, crosses ? 0.06 : 0.12));
    painter_.drawRect(box);
}

void ToolPainter::grid(double spacing) {
    const Box window = map_.window();
    const double columns = (window.max.x() - window.min.x()) / spacing, rows = (window.max.y() - window.min.y()) / spacing;
    if (!(columns * rows < 50000.0)) return;
    painter_.setRenderHint(QPainter::Antialiasing, false);
    painter_.setPen(QPen(theme_.text3, 1.4));
    const double left = std::ceil(window.min.x() / spacing), bottom = std::ceil(window.min.y() / spacing);
    for (double i = 0.0; i <= columns; ++i)
        for (double j = 0.0; j <= rows; ++j)
            painter_.drawPoint(map_.toPixel(Point((left + i) * spacing, (bottom + j) * spacing)));
    painter_.setRenderHint(QPainter::Antialiasing);
}

QRectF ToolPainter::prompt(QPainter& painter, const Theme& theme, const QString& text, const QString& detail, bool warns,
                       double room) {
    painter.setRenderHint(QPainter::Antialiasing);
    const QFont bold = fontOf(painter, 12, true), plain = fontOf(painter, 12);
    const double first = QFontMetricsF(bold).horizontalAdvance(text);
    const double most = std::max(room - 2.0 * inset - first - 54.0, 40.0);
    const QString shown = QFontMetricsF(plain).elidedText(detail, Qt::ElideRight, most);
    const double second = shown.isEmpty() ? 0.0 : QFontMetricsF(plain).horizontalAdvance(shown) + 26.0;
    const QRectF strip(inset, 10.0, first + second + 28.0, 28.0);
    painter.setPen(QPen(theme.border, 1.0));
    painter.setBrush(warns ? theme.warningSoft : theme.panel);
    painter.drawRoundedRect(strip.adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    painter.fillRect(QRectF(strip.left(), strip.top(), 3.0, strip.height()), warns ? theme.warningFill : theme.accent);
    painter.setFont(bold);
    painter.setPen(theme.text);
    painter.drawText(strip.adjusted(14.0, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, text);
    painter.setFont(plain);
    painter.setPen(warns ? theme.warning : theme.text2);
    painter.drawText(strip.adjusted(14.0 + first + 26.0, 0.0, 0.0, 0.0), Qt::AlignVCenter | Qt::AlignLeft, shown);
    return strip;
}

QString fieldText(double number) {
    if (!std::isfinite(number)) return QString::fromUtf8("–");
    const double size = std::abs(number);
    QString text;
    if (size != 0.0 && (size >= 1e6 || size < 1e-3))
        text = QString::number(number, 'g', 6);
    else if (std::abs(number * 100.0 - std::round(number * 100.0)) < 1e-9 * std::max(1.0, size * 100.0))
        text = QString::number(number, 'f', 2);
    else
        text = QString::number(number, 'g', 6);
    return text.replace('-', QChar(0x2212));
}

QString lengthText(double metres) {
    if (std::abs(metres) < 0.1 && metres != 0.0)
        return QString::number(metres, 'g', 3).replace('-', QChar(0x2212)) + QStringLiteral(" m");
    return QString::number(metres, 'f', 2).replace('-', QChar(0x2212)) + QStringLiteral(" m");
}

QString angleText(double degrees) {
    return QString::number(degrees, 'f', 1).replace('-', QChar(0x2212)) + QString::fromUtf8("°");
}

QString areaText(double squareMetres) {
    const bool small = squareMetres < 0.1 && squareMetres > 0.0;
    return QString::number(squareMetres, small ? 'g' : 'f', small ? 3 : 2) + QString::fromUtf8(" m²");
}

QString placeText(const Point& place) {
    const auto text = [](double number) {
        QString plain = QString::number(number, 'f', 2);
        if (plain == "-0.00") plain.remove(0, 1);
        return plain.replace('-', QChar(0x2212));
    };
    return text(place.x()) + ", " + text(place.y());
}

}  // namespace keyblock
