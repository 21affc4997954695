// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connects the canvas with the active tool: translates mouse and key events into points
// and steps, paints snap points and the prompt, and owns the palette, the bar and the
// coordinate box.
#pragma once

#include "ui/canvas/canvas_tool.h"
#include "ui/tools/workbench.h"

#include <QObject>

#include <memory>
#include <vector>

class QAction;
class QTimer;

namespace keyblock {

class Commands;
class CoordinateBox;
class SceneOverlay;
class Tool;
class ToolBar;
class ToolPalette;

class ToolDesk : public QObject, public CanvasTool {
    Q_OBJECT

public:
    ToolDesk(Canvas& canvas, Document& document, Selection& selection, const Visibility& visibility,
             const Display& display, const Themes& themes, Commands& commands, QObject* parent = nullptr);
    ~ToolDesk() override;

    /// `palette`: the column of tools at the left of the canvas. `bar`: the bar above the canvas. The caller places
    /// both.
    ToolPalette& palette() { return *palette_; }
    ToolBar& bar() { return *bar_; }
    Workbench& bench() { return *bench_; }

    Tool& tool() const { return *tool_; }
    void choose(const QString& id);

    /// True: the canvas shows the drawing. False: it shows results; the user can then select visible objects, but
    /// cannot draw or drag anything.
    void setDrawing(bool drawing);

    void press(const CanvasEvent& event) override;
    void doubleClick(const CanvasEvent& event) override;
    void move(const CanvasEvent& event) override;
    void release(const CanvasEvent& event) override;
    void leave() override;
    void contextMenu(const CanvasEvent& event, QPoint global) override;
    void paint(QPainter& painter, const CanvasMap& map) const override;
    QCursor cursor() const override;
    bool isDrawing() const override;

Q_SIGNALS:
    void chosen(const QString& id);
    void said(const QString& text, bool warns);  // also shown in the status bar
    void drawingAsked();  // a drawing tool was chosen while results are shown

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showTool();
    void showSelected();
    void showRoomToDraw();  // zooms to a default area if the scene is empty
    void stepBack();
    void enter();
    void take(const Point& typed);
    void tell(const QString& text, bool warns);
    Pointed pointed(const CanvasEvent& event) const;
    void follow(const Pointed& at);
    bool wants(QKeyEvent& event) const;
    bool handle(QKeyEvent& event);

    std::unique_ptr<Workbench> bench_;
    std::vector<std::unique_ptr<Tool>> tools_;
    Tool* tool_ = nullptr;
    std::unique_ptr<SceneOverlay> overlay_;
    ToolPalette* palette_;
    ToolBar* bar_;
    CoordinateBox* box_;
    std::vector<QAction*> actions_;  // actions that choose the tools
    std::optional<Pointed> at_;  // mouse position; none: the mouse is not over the canvas
    QString message_;
    bool warns_ = false;
    QTimer* forget_;  // clears the message after some seconds
};

}  // namespace keyblock
