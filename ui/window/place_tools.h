// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places the widgets of tools: their palette at the left of the canvas, their bar above
// it, their switches below; and informs them when results are shown.
#pragma once

class QHBoxLayout;
class QMainWindow;
class QVBoxLayout;

namespace keyblock {

class Canvas;
class Commands;
class DrawingFeed;
class Themes;
class ToolDesk;
class WorkflowBar;

struct ToolNeeds {
    QMainWindow& window;
    ToolDesk& desk;
    Canvas& canvas;
    DrawingFeed& drawing;
    WorkflowBar& workflow;
    const Commands& commands;
    const Themes& themes;
};

/// Where others add widgets around the canvas.
struct CanvasPlaces {
    QVBoxLayout& column;  // bars above it
    QHBoxLayout& row;  // a second canvas next to it
};

/// Makes the canvas with palette and bar the centre of the window.
CanvasPlaces placeTools(const ToolNeeds& needs);

}  // namespace keyblock
