// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mapping between points of the section and pixels. Pixels are those of the
// widget, device-independent, with y downwards; points are in metres, y upwards.
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

    /// Keeps the point in the middle.
    void resize(const QSizeF& size) { size_ = size; }
    /// Fits the box in `room` of the widget, centred. A box without extent becomes a metre large.
    void show(const Box& box, const QRectF& room);
    /// Keeps the point in the middle and the scale.
    void lookAs(const CanvasMap& other);
    void panBy(const QPointF& pixels);
    /// Keeps the point under `pixel`. The scale stays between 1e-4 and 1e7 px/m.
    void zoomBy(double factor, const QPointF& pixel);

private:
    void setScale(double scale);

    Point centre_{0.0, 0.0};  // [m]
    double scale_ = 100.0;  // px per m
    QSizeF size_{1.0, 1.0};
};

}  // namespace keyblock
