// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places the widgets of the tools: the palette at the left of the canvas, the bar above
// it and the switches below it. Informs the tools when results are shown.
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

/// Layouts around the canvas to which other parts add widgets.
struct CanvasPlaces {
    QVBoxLayout& column;  // canvas with bars above it
    QHBoxLayout& row;  // canvas with room for a second canvas next to it
};

/// Makes the canvas, together with the tool palette and the bar of tool options, the central widget of the window.
CanvasPlaces placeTools(const ToolNeeds& needs);

}  // namespace keyblock
