// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extensions of the canvas: a tool receives the mouse input over the section, and an
// overlay paints above it. The canvas itself zooms with the wheel and pans with the
// middle button, or with Space and the left button; tools do not receive these events.
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
    /// Handles a key; returns true if the tool used it.
    virtual bool key(QKeyEvent&) { return false; }
    virtual void contextMenu(const CanvasEvent&, QPoint /*global*/) {}
    /// Paints above the section and the overlays, in pixels.
    virtual void paint(QPainter&, const CanvasMap&) const {}
    /// Paints above the legend and other panels, in pixels.
    virtual void paintAbovePanels(QPainter&, const CanvasMap&) const {}
    virtual QCursor cursor() const { return Qt::ArrowCursor; }
    /// True once a first point is set; hints on how to start are then hidden.
    virtual bool isDrawing() const { return false; }
};

/// Paints above the section and below the tool: selection, problems, call-outs.
class CanvasOverlay {
public:
    virtual ~CanvasOverlay() = default;

    virtual void paint(QPainter&, const CanvasMap&) const = 0;
};

}  // namespace keyblock
