// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The transparent sheet above the section. What belongs to the picture is painted once
// per view and cached, so that a tool that follows the mouse only repaints its own
// strokes.
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

    /// Discards the cache; call when the picture or the view has changed.
    void forget() { kept_ = {}; }

    /// The quantity whose colour bar is under a pixel; null if there is none.
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
    std::vector<QRect> panels_;  // parts of the cache that are painted above overlays and tools
    std::vector<std::pair<LegendPart, QRectF>> parts_;  // colour bars of the legend
};

}  // namespace keyblock
