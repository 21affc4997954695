// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates and places the panels: the scene tree at the left, Properties at the right,
// and Problems, Stages, the bolt library and the model summary at the bottom.
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

/// The objects that the panels use.
struct PanelNeeds {
    Document& document;
    Selection& selection;
    Visibility& visibility;
    Display& display;
    Commands& commands;
    Themes& themes;
    Canvas& canvas;  // used to zoom to objects
};

/// The panels, for connecting them to other parts of the window.
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

/// Connects the workflow bar: a click on Support or Stages brings the bolt library or the Stages dock to the front.
void raiseAskedPanels(WorkflowBar& bar, const Panels& panels);

}  // namespace keyblock
