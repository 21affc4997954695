// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which place of the section lies under which pixel. Pixels are those of the
// widget, device-independent, with y downwards; places are metres, y upwards.
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
    /// What of the section is seen [m].
    Box window() const;
    QSizeF size() const { return size_; }
    Point centre() const { return centre_; }

    /// The place in the middle stays there.
    void resize(const QSizeF& size) { size_ = size; }
    /// All of the box, as large as `room` of the widget allows, in its middle. A box without extent gets a metre.
    void show(const Box& box, const QRectF& room);
    /// The same place in the middle, at the same scale.
    void lookAs(const CanvasMap& other);
    void panBy(const QPointF& pixels);
    /// The place under `pixel` stays there. The scale stays between 1e-4 and 1e7 px/m.
    void zoomBy(double factor, const QPointF& pixel);

private:
    void setScale(double scale);

    Point centre_{0.0, 0.0};  // [m]
    double scale_ = 100.0;  // px per m
    QSizeF size_{1.0, 1.0};
};

}  // namespace keyblock
