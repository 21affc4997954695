// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mapping between points of the section and pixels. Points are in metres with y
// upwards; pixels are device-independent pixels of the widget with y downwards.
#pragma once

#include "geometry/polygon.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace keyblock {

class CanvasMap {
public:
    QPointF toPixel(const Point& place) const;
    Point toPlace(const QPointF& pixel) const;
    double pixelsPerMetre() const { return scale_; }
    /// The visible part of the section [m].
    Box window() const;
    QSizeF size() const { return size_; }
    Point centre() const { return centre_; }

    /// Sets the size of the widget [px]. The centre of the view does not change.
    void resize(const QSizeF& size) { size_ = size; }
    /// Scales and centres the view so that the box fits into the part `room` of the widget. A box of zero size is
    /// treated as 1 m wide and high.
    void show(const Box& box, const QRectF& room);
    /// Copies the centre and the scale of another map.
    void lookAs(const CanvasMap& other);
    void panBy(const QPointF& pixels);
    /// Zooms by a factor, keeping the point under `pixel` fixed. The scale is limited to 1e-4 … 1e7 px/m.
    void zoomBy(double factor, const QPointF& pixel);

private:
    void setScale(double scale);

    Point centre_{0.0, 0.0};  // [m]
    double scale_ = 100.0;  // px per m
    QSizeF size_{1.0, 1.0};
};

}  // namespace keyblock
