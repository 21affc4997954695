// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/canvas_sheet.h"

#include "ui/canvas/call_out.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/canvas_caption.h"
#include "ui/canvas/section_painter.h"
#include "ui/look/theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace keyblock {

CanvasSheet::CanvasSheet(Canvas& canvas) : QWidget(&canvas), canvas_(canvas) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setAttribute(Qt::WA_TranslucentBackground);
    setFocusPolicy(Qt::NoFocus);
}

void CanvasSheet::paintEvent(QPaintEvent*) {
    if (kept_.isNull()) {
        panels_.clear();
        parts_.clear();
        kept_ = QPixmap(size() * devicePixelRatioF());
        kept_.setDevicePixelRatio(devicePixelRatioF());
        kept_.fill(Qt::transparent);
        QPainter painter(&kept_);
        painter.setRenderHint(QPainter::Antialiasing);
        if (canvas_.picture()) paintPicture(painter);
    }
    const double ratio = devicePixelRatioF();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawPixmap(0, 0, kept_);
    const bool begins = !canvas_.tool() || !canvas_.tool()->isDrawing();
    if (!canvas_.picture() && !canvas_.hintAside_ && begins) paintHint(painter);
    for (const CanvasOverlay* overlay : canvas_.overlays_) {
        painter.save();
        overlay->paint(painter, canvas_.map());
        painter.restore();
    }
    if (!canvas_.picture() && canvas_.hintAside_) paintHintAside(painter);
    if (canvas_.tool()) canvas_.tool()->paint(painter, canvas_.map());
    for (const QRect& panel : panels_)
        painter.drawPixmap(panel, kept_, QRectF(panel.topLeft() * ratio, panel.size() * ratio).toRect());
    if (canvas_.tool()) canvas_.tool()->paintAbovePanels(painter, canvas_.map());
    if (canvas_.boxFrom_) paintBox(painter, QRectF(*canvas_.boxFrom_, *canvas_.boxTo_).normalized());
}

void CanvasSheet::paintBox(QPainter& painter, const QRectF& box) const {
    QColor fill = canvas_.themes_.current().accent;
    painter.setPen(QPen(fill, 1.2));
    fill.setAlphaF(0.1);
    painter.setBrush(fill);
    painter.drawRect(box);
}

void CanvasSheet::paintHint(QPainter& painter) const {
    const Theme& theme = canvas_.themes_.current();
    QFont title = font();
    title.setPixelSize(16);
    title.setWeight(QFont::DemiBold);
    painter.setFont(title);
    painter.setPen(theme.text2);
    const QRectF middle(0.0, 0.5 * height() - 32.0, width(), 24.0);
    painter.drawText(middle, Qt::AlignCenter, canvas_.hintTitle_);
    painter.setFont(font());
    painter.setPen(theme.text3);
    painter.drawText(middle.translated(0.0, 28.0), Qt::AlignCenter, canvas_.hintText_);
}

/// Paints the hint on a panel, so that it is readable over any background.
void CanvasSheet::paintHintAside(QPainter& painter) const {
    const Theme& theme = canvas_.themes_.current();
    const QFont title = screenFont(12, true), details = screenFont(11);
    const double wide = 32.0 + std::max(QFontMetricsF(title).horizontalAdvance(canvas_.hintTitle_),
                                        QFontMetricsF(details).horizontalAdvance(canvas_.hintText_));
    const QRectF panel(0.5 * (width() - wide), height() - 60.0, wide, 48.0);
    paintPanel(painter, theme, panel);
    painter.setFont(title);
    painter.setPen(theme.text);
    painter.drawText(panel.adjusted(0.0, 7.0, 0.0, -23.0), Qt::AlignCenter, canvas_.hintTitle_);
    painter.setFont(details);
    painter.setPen(theme.text2);
    painter.drawText(panel.adjusted(0.0, 23.0, 0.0, -7.0), Qt::AlignCenter, canvas_.hintText_);
}

void CanvasSheet::paintPicture(QPainter& painter) {
    const bool hasLegend = canvas_.hasLegend_ && !canvas_.style_.drawing;
    std::vector<QRectF> captions;
    for (const CanvasCaption* caption : canvas_.findChildren<CanvasCaption*>())
        if (caption->isVisible()) captions.push_back(caption->geometry());
    SectionPainter section(*canvas_.picture(), canvas_.map(), canvas_.themes_.current(), hasLegend,
                           canvas_.style_.selectedBolts, canvas_.highlighted_, std::move(captions));
    section.paint(painter);
    for (const QRectF& panel : section.panels()) panels_.push_back(panel.toAlignedRect());
    for (const LegendPart part : {LegendPart::Blocks, LegendPart::Bolts})
        if (const QRectF rect = section.legendPart(part); !rect.isEmpty()) parts_.emplace_back(part, rect);
}

std::optional<LegendPart> CanvasSheet::legendPartAt(const QPointF& pixel) const {
    for (const auto& [part, rect] : parts_)
        if (rect.contains(pixel)) return part;
    return std::nullopt;
}

}  // namespace keyblock
