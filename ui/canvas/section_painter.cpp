// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/section_painter.h"

#include "ui/canvas/scale_bar.h"
#include "ui/canvas/screen_marks.h"
#include "ui/look/theme.h"
#include "ui/picture/section/detail.h"
#include "ui/view/screen_sizes.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace keyblock {

namespace {

constexpr double edge = 6.0, nearBolt = 9.0, leastSpacingForNames = 17.0;  // [px]
constexpr std::size_t manyAnchors = 12;

QRectF rectOfBox(const Box& box) { return {QPointF(box.min.x(), box.min.y()), QPointF(box.max.x(), box.max.y())}; }
Box boxOf(const QRectF& rect) { return {{rect.left(), rect.top()}, {rect.right(), rect.bottom()}}; }
Box sheetOf(const CanvasMap& map) { return {{edge, edge}, {map.size().width() - edge, map.size().height() - edge}}; }

}  // namespace

SectionPainter::SectionPainter(const SectionPicture& picture, const CanvasMap& map, const Theme& theme,
                               bool hasLegend, const std::vector<int>& selected,
                               const std::optional<HighlightedBlock>& highlighted, std::vector<QRectF> covered)
    : picture_(picture), map_(map), theme_(theme), hasLegend_(hasLegend), selected_(selected), highlighted_(highlighted),
      covered_(std::move(covered)), placement_(sheetOf(map), pixelsPerMm) {
    if (picture.contacts) contacts_ = seenWithin(*picture.contacts, map.window());
    moved_ = movedBlocks(picture, map.pixelsPerMetre(), onTheScreen);
    chooseMarks();
}

void SectionPainter::chooseMarks() {
    const double scale = map_.pixelsPerMetre();
    spacing_ = boltSpacing(picture_, scale, onTheScreen);
    for (std::size_t i = 0; i < picture_.bolts.size(); ++i)
        marks_.push_back(marksToDraw(picture_.bolts[i], spacing_[i], scale, onTheScreen));
}

Point SectionPainter::onSheet(const Point& place) const {
    const QPointF pixel = map_.toPixel(place);
    return {pixel.x(), pixel.y()};
}

QPolygonF SectionPainter::onSheet(const std::vector<Point>& places) const {
    QPolygonF polygon;
    for (const Point& place : places) polygon << map_.toPixel(place);
    return polygon;
}

std::vector<Point> SectionPainter::sheetPoints(const std::vector<Point>& places) const {
    std::vector<Point> points;
    for (const Point& place : places) points.push_back(onSheet(place));
    return points;
}

bool SectionPainter::isSelected(const BoltShape& bolt) const {
    return std::find(selected_.begin(), selected_.end(), bolt.bolt) != selected_.end();
}

bool SectionPainter::isSeen(const Point& place) const { return meets({place, place}, sheetOf(map_)); }

void SectionPainter::paint(QPainter& painter) {
    paintMoved(painter);
    paintHighlighted(painter);
    paintBroken(painter);
    paintDashes(painter);
    keepOffPanels();
    keepOffBolts();
    paintRibbon(painter);
    paintMarks(painter);
    paintNames(painter);
    callOutEvents();
    callOutMoved();
    paintCallOuts(painter);
    paintPanels(painter);
}

void SectionPainter::keepOffBolts() {
    for (const BoltShape& bolt : picture_.bolts)
        placement_.keepOff(onSheet(bolt.nodes.front()), onSheet(bolt.nodes.back()), nearBolt);
    for (const LineShape& wall : picture_.walls) placement_.keepLabelsOff(onSheet(wall.from), onSheet(wall.to));
}

LegendContent SectionPainter::legendContent() const {
    return {picture_, contacts_ ? &*contacts_ : nullptr, kindsOf(marks_), highlighted_.has_value(), map_.pixelsPerMetre()};
}

/// Panels are placed first and painted last, over everything else.
void SectionPainter::keepOffPanels() {
    for (const QRectF& panel : panels()) placement_.keepOff(grown(boxOf(panel), 4.0));
    for (const QRectF& widget : covered_) placement_.keepOff(grown(boxOf(widget), 4.0));
}

std::vector<QRectF> SectionPainter::panels() const {
    std::vector<QRectF> panels;
    if (hasLegend_) panels.push_back(legendRect(theme_, legendContent(), map_.size()));
    panels.push_back(scaleBarRect(map_));
    std::erase_if(panels, [](const QRectF& panel) { return panel.isEmpty(); });
    return panels;
}

QRectF SectionPainter::legendPart(LegendPart part) const {
    return hasLegend_ ? legendPartRect(theme_, legendContent(), map_.size(), part) : QRectF();
}

void SectionPainter::paintPanels(QPainter& painter) const {
    if (hasLegend_) paintLegend(painter, theme_, legendContent(), map_.size());
    paintScaleBar(painter, theme_, map_);
}

void SectionPainter::paintMoved(QPainter& painter) const {
    QPen pen(theme_.wall, 1.0);
    pen.setDashPattern({5.0, 3.0});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    for (const BlockShape* block : moved_) painter.drawPolygon(onSheet(block->before));
}

void SectionPainter::paintHighlighted(QPainter& painter) const {
    if (!highlighted_) return;
    for (const BlockShape& block : picture_.blocks) {
        if (block.block != highlighted_->block) continue;
        QColor fill = theme_.warningFill;
        fill.setAlphaF(0.14);
        QPen pen(theme_.warningFill, 2.0);
        pen.setDashPattern({2.5, 1.5});
        painter.setPen(QPen(theme_.markCasing, 3.5));
        painter.setBrush(fill);
        painter.drawPolygon(onSheet(block.outline));
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(onSheet(block.outline));
    }
}

/// Paints dashes within the bar where its force is compressive, because the colours show only the magnitude.
void SectionPainter::paintDashes(QPainter& painter) const {
    if (!picture_.boltLegend || picture_.boltLegend->dashed.empty()) return;
    QPen pen(theme_.markCasing, std::max(1.2, 0.36 * shankWidth(picture_, map_.pixelsPerMetre())));
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern({3.0, 3.0});
    painter.setPen(pen);
    for (const BoltShape& bolt : picture_.bolts) {
        QPolygonF run;
        const auto end = [&] {
            if (run.size() > 1) painter.drawPolyline(run);
            run.clear();
        };
        for (std::size_t e = 0; e < bolt.values.size(); ++e) {
            const bool dashed = !bolt.broken[e] && picture_.boltLegend->isDashed(bolt.values[e]);
            if (dashed && run.isEmpty()) run << map_.toPixel(bolt.nodes[e]);
            if (dashed) run << map_.toPixel(bolt.nodes[e + 1]);
            else end();
        }
        end();
    }
}

/// Paints a thin dashed line where the steel is lost.
void SectionPainter::paintBroken(QPainter& painter) const {
    QPen pen(theme_.text2, 1.0);
    pen.setDashPattern({4.0, 3.0});
    painter.setPen(pen);
    for (const BoltShape& bolt : picture_.bolts)
        for (std::size_t e = 0; e + 1 < bolt.nodes.size(); ++e)
            if (bolt.broken[e]) painter.drawLine(map_.toPixel(bolt.nodes[e]), map_.toPixel(bolt.nodes[e + 1]));
}

void SectionPainter::paintMarks(QPainter& painter) const {
    const MarkTheme theme = screenMarks(theme_);
    for (const std::vector<Mark>& marks : marks_) {
        const auto real = std::count_if(marks.begin(), marks.end(), [](const Mark& m) { return !isArtificial(m.kind); });
        const bool small = static_cast<std::size_t>(real) > manyAnchors;
        for (const Mark& mark : marks)
            if (isSeen(onSheet(mark.place)))
                paintMark(painter, mark.kind, map_.toPixel(mark.place), {mark.along.x(), -mark.along.y()}, small, theme);
    }
}

void SectionPainter::paintNames(QPainter& painter) {
    for (std::size_t i = 0; i < picture_.bolts.size(); ++i) {
        const BoltShape& bolt = picture_.bolts[i];
        const Point farEnd = onSheet(bolt.nodes.front()), head = onSheet(bolt.nodes.back());
        if (!isSeen(farEnd) && !isSeen(head)) continue;
        painter.setFont(screenFont(12, isSelected(bolt)));
        const QFontMetricsF metrics(painter.font());
        const QString name = metrics.elidedText(QString::fromStdString(bolt.name), Qt::ElideMiddle, 110.0);
        const Point size(metrics.horizontalAdvance(name) + (isSelected(bolt) ? 14.0 : 4.0), isSelected(bolt) ? 18.0 : 15.0);
        const Point upwards = alongOf(bolt.nodes), along(upwards.x(), -upwards.y()), across = turnLeft(along);
        std::vector<Point> centres;
        const auto beside = [&](const Point& end, const Point& away) {
            centres.push_back(end + (nearBolt + 1.0 + 0.5 * away.cwiseAbs().dot(size)) * away);
        };
        for (const Point& away : {Point(-along), Point(across - along), Point(-across - along), across, Point(-across)})
            beside(farEnd, away.normalized());
        beside(head, along);
        if (spacing_[i] < leastSpacingForNames) centres.resize(1);
        if (const auto box = placement_.place(size, centres)) paintName(painter, bolt, name, rectOfBox(*box));
    }
}

void SectionPainter::paintName(QPainter& painter, const BoltShape& bolt, const QString& name, const QRectF& box) const {
    if (isSelected(bolt)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme_.accent);
        painter.drawRoundedRect(box, 3.0, 3.0);
        painter.setPen(theme_.onAccent);
        painter.drawText(box, Qt::AlignCenter, name);
        return;
    }
    const double width = QFontMetricsF(painter.font()).horizontalAdvance(name);
    paintCased(painter, theme_, {box.center().x() - 0.5 * width, box.bottom() - 3.0}, name, theme_.text);
}

/// Point in a block for the end of a leader: its centroid, or half way to a corner if a bolt crosses there.
Point SectionPainter::footWithin(const std::vector<Point>& outline) const {
    const Point centroid = moments(outline).centroid, room(8.0, 8.0);
    if (placement_.isFree(boxAbout(centroid, room))) return centroid;
    for (const Point& corner : outline)
        if (const Point place = 0.5 * (centroid + corner); placement_.isFree(boxAbout(place, room))) return place;
    return centroid;
}

void SectionPainter::paintCallOuts(QPainter& painter) {
    for (const CallOut& callOut : callOuts_) {
        const QSizeF size = sizeOf(callOut);
        const auto box = placement_.placeRound({size.width() + 8.0, size.height() + 8.0}, callOut.at, callOut.first);
        if (box) paintCallOut(painter, theme_, callOut, rectOfBox(grown(*box, -4.0)));
    }
}

}  // namespace keyblock
