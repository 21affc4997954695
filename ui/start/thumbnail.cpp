// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/thumbnail.h"

#include "ui/look/theme.h"
#include "ui/picture/colour.h"
#include "ui/picture/section/marks.h"
#include "ui/picture/section/section.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <optional>

namespace keyblock {

namespace {

constexpr double large = 160.0;  // [px] height of a picture from which marks are drawn
constexpr std::size_t manyBlocks = 12;
constexpr double mostHeart = 0.7;  // if the main part exceeds this fraction of the rock's extent, all rock is shown
constexpr double widest = 1.8;  // largest width of the main part, relative to the height; a card may clip the rest

QColor colourOf(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

void widen(Box& box, const Point& p) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
}

/// Box around the tunnels and bolts, with some rock around them, if the rock has many blocks. There is none if the box
/// would contain nearly everything.
std::optional<Box> heartOf(const SectionPicture& picture) {
    if (picture.blocks.size() <= manyBlocks || (picture.bolts.empty() && picture.walls.empty())) return {};
    const Point first = picture.walls.empty() ? picture.bolts.front().nodes.front() : picture.walls.front().from;
    Box box{first, first};
    for (const BoltShape& bolt : picture.bolts)
        for (const Point& node : bolt.nodes) widen(box, node);
    for (const LineShape& wall : picture.walls) {
        widen(box, wall.from);
        widen(box, wall.to);
    }
    const Point extent = box.max - box.min, all = picture.model.max - picture.model.min;
    if (extent.x() > mostHeart * all.x() || extent.y() > mostHeart * all.y()) return {};
    const double rim = (picture.bolts.empty() ? 0.5 : 0.12) * extent.maxCoeff();
    return Box{box.min - Point(rim, rim), box.max + Point(rim, rim)};
}

class Painting {
public:
    Painting(const SectionPicture& picture, QImage& image, double ratio, const Theme& theme, ThumbnailView view)
        : picture_(picture), theme_(theme), painter_(&image), size_(image.width() / ratio, image.height() / ratio) {
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.scale(ratio, ratio);
        place(view);
    }

    void paint() {
        if (picture_.blocks.empty()) return;
        for (std::size_t i = 0; i < picture_.blocks.size(); ++i) paintBlock(i);
        paintLines(picture_.walls, QPen(theme_.wall, isLarge() ? 1.6 : 1.0));
        for (const BoltShape& bolt : picture_.bolts) paintBolt(bolt);
    }

private:
    bool isLarge() const { return size_.height() >= large; }

    void place(ThumbnailView view) {
        const bool isAll = view == ThumbnailView::Everything;
        const std::optional<Box> heart = isAll ? std::nullopt : heartOf(picture_);
        const Box box = heart.value_or(picture_.model);
        const Point extent = (box.max - box.min).cwiseMax(1e-9);
        const double width = isAll ? size_.width() : std::min(size_.width(), widest * size_.height());
        const double fit = std::min(width / extent.x(), size_.height() / extent.y());
        scale_ = heart ? fit : 0.84 * fit;
        middle_ = 0.5 * (box.min + box.max);
    }

    QPointF at(const Point& p) const {
        return {0.5 * size_.width() + scale_ * (p.x() - middle_.x()),
                0.5 * size_.height() - scale_ * (p.y() - middle_.y())};
    }

    QPolygonF polygon(const std::vector<Point>& points) const {
        QPolygonF shape;
        for (const Point& p : points) shape << at(p);
        return shape;
    }

    QColor tint(std::size_t index) const {
        const bool isMany = picture_.blocks.size() > manyBlocks;
        const double chance = std::fmod(static_cast<double>(index) * 0.6180339887, 1.0);
        const double share = isMany ? 0.14 + 0.42 * chance : index % 2 ? 0.2 : 0.3;
        return colourOf(colourAt(theme_.dark ? slateDark : slate, share));
    }

    void paintBlock(std::size_t index) {
        painter_.setPen(QPen(theme_.jointLine, isLarge() ? 0.9 : 0.5));
        painter_.setBrush(tint(index));
        painter_.drawPolygon(polygon(picture_.blocks[index].outline));
    }

    void paintLines(const std::vector<LineShape>& lines, const QPen& pen) {
        painter_.setPen(pen);
        for (const LineShape& line : lines) painter_.drawLine(at(line.from), at(line.to));
    }

    void paintBolt(const BoltShape& bolt) {
        const QPolygonF line = polygon(bolt.nodes);
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(QPen(theme_.markCasing, isLarge() ? 5.6 : 2.6, Qt::SolidLine, Qt::RoundCap));
        painter_.drawPolyline(line);
        const QColor shank = colourOf(colourAt(theme_.dark ? emberDark : ember, theme_.dark ? 0.6 : 0.35));
        painter_.setPen(QPen(shank, isLarge() ? 3.4 : 1.6, Qt::SolidLine, Qt::RoundCap));
        painter_.drawPolyline(line);
        if (isLarge())
            for (const Mark& mark : thinned(bolt.marks, 8.0 / scale_)) paintMark(mark);
    }

    void paintMark(const Mark& mark) {
        const QPointF place = at(mark.place);
        painter_.setPen(QPen(theme_.markCasing, 1.0));
        painter_.setBrush(theme_.markInk);
        if (mark.kind == MarkKind::Bonded) painter_.drawEllipse(place, 3.4, 3.4);
        if (mark.kind == MarkKind::Plate) paintPlate(place, mark.along);
    }

    void paintPlate(const QPointF& place, const Point& along) {
        painter_.save();
        painter_.translate(place);
        painter_.rotate(-std::atan2(along.y(), along.x()) * 180.0 / M_PI);
        painter_.drawRect(QRectF(-1.9, -5.2, 3.8, 10.4));
        painter_.restore();
    }

    const SectionPicture& picture_;
    const Theme& theme_;
    QPainter painter_;
    QSizeF size_;
    double scale_ = 1.0;  // [px/m]
    Point middle_{0.0, 0.0};
};

}  // namespace

QImage paintThumbnail(const SectionPicture& picture, QSize pixels, double ratio, const Theme& theme,
                      ThumbnailView view) {
    QImage image(pixels, QImage::Format_RGB32);
    image.fill(theme.canvas);
    Painting(picture, image, ratio, theme, view).paint();
    image.setDevicePixelRatio(ratio);
    return image;
}

}  // namespace keyblock
