// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the panels and puts them where a person expects them: the tree at the
// left, properties at the right, problems, stages, bolt library and census below.
#pragma once

class QDockWidget;
class QMainWindow;

namespace keyblock {

class Canvas;
class CensusPanel;
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
    Canvas& canvas;  // shows what they point at
};

/// The panels, for those who connect them.
struct Panels {
    SceneTree* tree = nullptr;
    PropertyPanel* properties = nullptr;
    ProblemsPanel* problems = nullptr;
    CensusPanel* census = nullptr;
    StagesPanel* stages = nullptr;
    LibraryPanel* library = nullptr;
    QDockWidget *problemsDock = nullptr, *censusDock = nullptr, *stagesDock = nullptr, *libraryDock = nullptr;
};

Panels placePanels(QMainWindow& window, const PanelNeeds& needs);

/// A click on a step of the work brings the dock forward in which it is done.
void raiseAskedPanels(WorkflowBar& bar, const Panels& panels);

}  // namespace keyblock
