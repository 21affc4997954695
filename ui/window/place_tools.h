// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Places what tools show: their palette at the left of the canvas, their bar above
// it, their switches at the foot; and tells them when results are looked at.
#pragma once

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

/// Makes the canvas with palette and bar the middle of the window. The column that holds bar and canvas comes back, for
/// other bars.
QVBoxLayout& placeTools(const ToolNeeds& needs);

}  // namespace keyblock
