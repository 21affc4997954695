// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_map.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

QPointF CanvasMap::toPixel(const Point& place) const {
    const Point offset = scale_ * (place - centre_);
    return {0.5 * size_.width() + offset.x(), 0.5 * size_.height() - offset.y()};
}

Point CanvasMap::toPlace(const QPointF& pixel) const {
    return centre_ + Point(pixel.x() - 0.5 * size_.width(), 0.5 * size_.height() - pixel.y()) / scale_;
}

Box CanvasMap::window() const {
    const Point half = Point(0.5 * size_.width(), 0.5 * size_.height()) / scale_;
    return {centre_ - half, centre_ + half};
}

void CanvasMap::setScale(double scale) {
    if (std::isfinite(scale)) scale_ = std::clamp(scale, 1e-4, 1e7);
}

void CanvasMap::show(const Box& box, const QRectF& room) {
    if (!box.min.allFinite() || !box.max.allFinite() || room.isEmpty()) return;
    Point extent = (box.max - box.min).cwiseMax(0.0);
    if (extent.maxCoeff() <= 0.0) extent = {1.0, 1.0};
    setScale(std::min(room.width() / std::max(extent.x(), 1e-9), room.height() / std::max(extent.y(), 1e-9)));
    const QPointF aside = room.center() - QPointF(0.5 * size_.width(), 0.5 * size_.height());
    centre_ = 0.5 * (box.min + box.max) - Point(aside.x(), -aside.y()) / scale_;
}

void CanvasMap::lookAs(const CanvasMap& other) {
    centre_ = other.centre_;
    scale_ = other.scale_;
}

void CanvasMap::panBy(const QPointF& pixels) { centre_ -= Point(pixels.x(), -pixels.y()) / scale_; }

void CanvasMap::zoomBy(double factor, const QPointF& pixel) {
    const Point kept = toPlace(pixel);
    setScale(scale_ * factor);
    centre_ += kept - toPlace(pixel);
}

}  // namespace keyblock
