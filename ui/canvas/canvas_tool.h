// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extensions of the canvas: a tool receives the mouse input over the section, an
// overlay paints above it. The canvas itself zooms with the wheel and pans with the
// middle button or with Space and the left one; a tool does not see those events.
#pragma once

#include "ui/canvas/canvas_map.h"

#include <QCursor>
#include <QPointF>
#include <Qt>

class QKeyEvent;
class QPainter;

namespace keyblock {

struct CanvasEvent {
    Point place{0.0, 0.0};  // [m]
    QPointF pixel;
    Qt::MouseButton button = Qt::NoButton;
    Qt::MouseButtons buttons = Qt::NoButton;
    Qt::KeyboardModifiers modifiers = Qt::NoModifier;
};

class CanvasTool {
public:
    virtual ~CanvasTool() = default;

    virtual void press(const CanvasEvent&) {}
    virtual void doubleClick(const CanvasEvent&) {}
    virtual void move(const CanvasEvent&) {}
    virtual void release(const CanvasEvent&) {}
    virtual void leave() {}
    /// True if the tool used the key.
    virtual bool key(QKeyEvent&) { return false; }
    virtual void contextMenu(const CanvasEvent&, QPoint /*global*/) {}
    /// Painted above the section and the overlays, in pixels.
    virtual void paint(QPainter&, const CanvasMap&) const {}
    /// The same above the legend and other panels.
    virtual void paintAbovePanels(QPainter&, const CanvasMap&) const {}
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    /// True once it has a first point: hints on how to start are then hidden.
    virtual bool isDrawing() const { return false; }
};

/// Painted above the section and below the tool: selection, problems, call-outs.
class CanvasOverlay {
public:
    virtual ~CanvasOverlay() = default;

    virtual void paint(QPainter&, const CanvasMap&) const = 0;
};

}  // namespace keyblock
