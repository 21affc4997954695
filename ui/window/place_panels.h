// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates and places the panels: the tree at the left, properties at the right,
// problems, stages, bolt library and model summary below.
#pragma once

class QDockWidget;
class QMainWindow;

namespace keyblock {

class Canvas;
class ModelSummaryPanel;
class Commands;
class Display;
class Document;
class LibraryPanel;
class ProblemsPanel;
class PropertyPanel;
class SceneTree;
class Selection;
class StagesPanel;
class Themes;
class Visibility;
class WorkflowBar;

/// What the panels work on.
struct PanelNeeds {
    Document& document;
    Selection& selection;
    Visibility& visibility;
    Display& display;
    Commands& commands;
    Themes& themes;
    Canvas& canvas;  // shows the locations they refer to
};

/// The panels, for connections to other parts.
struct Panels {
    SceneTree* tree = nullptr;
    PropertyPanel* properties = nullptr;
    ProblemsPanel* problems = nullptr;
    ModelSummaryPanel* summary = nullptr;
    StagesPanel* stages = nullptr;
    LibraryPanel* library = nullptr;
    QDockWidget *problemsDock = nullptr, *summaryDock = nullptr, *stagesDock = nullptr, *libraryDock = nullptr;
};

Panels placePanels(QMainWindow& window, const PanelNeeds& needs);

/// A click on a workflow step brings the dock for that step to the front.
void raiseAskedPanels(WorkflowBar& bar, const Panels& panels);

}  // namespace keyblock
