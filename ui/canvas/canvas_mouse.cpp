// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mouse and key input of the canvas itself, and what it passes on to the tool.
#include "ui/canvas/canvas.h"

#include "ui/canvas/canvas_sheet.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {

namespace {

constexpr double leastBox = 4.0;  // smallest size of a box [px]
constexpr double zoomOfNotch = 1.2, degreesOfNotch = 15.0;

}  // namespace

CanvasEvent Canvas::eventOf(const QMouseEvent& event) const {
    return {map_.toPlace(event.localPos()), event.localPos(), event.button(), event.buttons(), event.modifiers()};
}

bool Canvas::startsPan(const QMouseEvent& event) const {
    return event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && spaceDown_);
}

void Canvas::showCursor(const std::optional<QPointF>& pixel) {
    const bool onLegend = pixel && sheet_->legendPartAt(*pixel) && held_ == Qt::NoButton;
    const QString tip = onLegend && !boxWanted_ ? tr("Click to change the colour scale.") : QString();
    if (tip != toolTip()) setToolTip(tip);
    if (panFrom_) setCursor(Qt::ClosedHandCursor);
    else if (boxWanted_) setCursor(Qt::CrossCursor);
    else if (spaceDown_) setCursor(Qt::OpenHandCursor);
    else if (onLegend) setCursor(Qt::PointingHandCursor);
    else setCursor(tool_ ? tool_->cursor() : QCursor(Qt::ArrowCursor));
}

void Canvas::startZoomBox() {
    boxWanted_ = true;
    showCursor();
}

bool Canvas::endZoomBox() {
    boxFrom_.reset();
    boxTo_.reset();
    if (!std::exchange(boxWanted_, false)) return false;
    showCursor();
    refresh();
    return true;
}

void Canvas::mousePressEvent(QMouseEvent* event) {
    if (startsPan(*event)) {
        panFrom_ = event->localPos();
        spacePanned_ = spaceDown_;
        showCursor();
    } else if (boxWanted_) {
        if (event->button() == Qt::LeftButton) boxFrom_ = boxTo_ = event->localPos();
    } else if (const auto part = sheet_->legendPartAt(event->localPos()); part && event->button() == Qt::LeftButton) {
        const int left = width() - static_cast<int>(legendExtent) - 6;  // next to the legend, not over it
        Q_EMIT legendClicked(*part, mapToGlobal({left, event->pos().y() - 20}));
    } else if (tool_ && !panFrom_) {
        held_ |= event->button();
        tool_->press(eventOf(*event));
        showCursor();
    }
}

void Canvas::mouseMoveEvent(QMouseEvent* event) {
    if (panFrom_) {
        panBy(event->localPos() - *panFrom_);
        panFrom_ = event->localPos();
    } else if (boxWanted_) {
        if (boxFrom_) boxTo_ = event->localPos();
        refresh();
    } else {
        if (tool_) tool_->move(eventOf(*event));
        showCursor(event->localPos());
    }
    Q_EMIT hovered(map_.toPlace(event->localPos()), true);
}

void Canvas::mouseReleaseEvent(QMouseEvent* event) {
    const bool endsPan = event->button() == Qt::MiddleButton || event->button() == Qt::LeftButton;
    if (tool_ && held_ & event->button()) {
        held_ &= ~Qt::MouseButtons(event->button());
        tool_->release(eventOf(*event));
        showCursor();
    } else if (panFrom_ && endsPan) {
        panFrom_.reset();
        showCursor();
    } else if (boxFrom_ && event->button() == Qt::LeftButton) {
        const QRectF box = QRectF(*boxFrom_, *boxTo_).normalized();
        endZoomBox();
        if (std::min(box.width(), box.height()) >= leastBox)
            zoomTo({map_.toPlace(box.bottomLeft()), map_.toPlace(box.topRight())});
    }
}

void Canvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton) {
        panFrom_.reset();
        fit();
    } else if (startsPan(*event) || boxWanted_) {
        mousePressEvent(event);
    } else if (tool_) {
        held_ |= event->button();
        tool_->doubleClick(eventOf(*event));
        showCursor();
    }
}

void Canvas::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 8.0 / degreesOfNotch;
    event->accept();
    if (notches == 0.0) return;
    zoomBy(std::pow(zoomOfNotch, notches), event->position());
    Q_EMIT hovered(map_.toPlace(event->position()), true);
}

void Canvas::leaveEvent(QEvent*) {
    if (tool_) tool_->leave();
    Q_EMIT hovered(Point(0.0, 0.0), false);
}

void Canvas::contextMenuEvent(QContextMenuEvent* event) {
    const QPointF pixel = event->pos();
    if (endZoomBox()) return;
    if (tool_) tool_->contextMenu({map_.toPlace(pixel), pixel, Qt::RightButton, Qt::NoButton, event->modifiers()},
                                  event->globalPos());
}

void Canvas::keyPressEvent(QKeyEvent* event) {
    const bool isSpace = event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier;
    if (isSpace && !event->isAutoRepeat() && !spaceDown_) {
        spaceDown_ = true;
        spacePanned_ = false;
        showCursor();
    }
    if (isSpace) return;
    if (tool_ && tool_->key(*event)) {
        event->accept();
        showCursor();
        return;
    }
    QWidget::keyPressEvent(event);
}

void Canvas::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Space || event->isAutoRepeat()) return QWidget::keyReleaseEvent(event);
    const bool tapped = spaceDown_ && !spacePanned_;
    spaceDown_ = false;
    showCursor();
    if (tapped) Q_EMIT spaceTapped();
}

void Canvas::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    spaceDown_ = false;
    showCursor();
}

}  // namespace keyblock
