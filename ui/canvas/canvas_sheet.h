// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The transparent sheet above the section. The parts that belong to the picture are
// painted once per view and cached, so that a tool that follows the mouse costs only
// its own strokes.
#pragma once

#include "ui/canvas/legend_panel.h"

#include <QPixmap>
#include <QWidget>

#include <optional>
#include <utility>
#include <vector>

namespace keyblock {

class Canvas;

class CanvasSheet : public QWidget {
    Q_OBJECT

public:
    explicit CanvasSheet(Canvas& canvas);

    /// The picture or the view changed.
    void forget() { kept_ = {}; }

    /// The quantity whose legend bar is under a pixel.
    std::optional<LegendPart> legendPartAt(const QPointF& pixel) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBox(QPainter& painter, const QRectF& box) const;
    void paintHint(QPainter& painter) const;
    void paintHintAside(QPainter& painter) const;
    void paintPicture(QPainter& painter);

    Canvas& canvas_;
    QPixmap kept_;
    std::vector<QRect> panels_;  // cached: the part above overlays and tools
    std::vector<std::pair<LegendPart, QRectF>> parts_;  // of the legend
};

}  // namespace keyblock
