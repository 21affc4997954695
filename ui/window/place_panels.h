// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the panels and puts them where a person expects them: the tree at the
// left, properties at the right.
#pragma once

class QMainWindow;

namespace keyblock {

class Commands;
class Display;
class Document;
class PropertyPanel;
class SceneTree;
class Selection;
class Themes;
class Visibility;

/// What the panels work on.
struct PanelNeeds {
    Document& document;
    Selection& selection;
    Visibility& visibility;
    Display& display;
    Commands& commands;
    Themes& themes;
};

/// The panels, for those who connect them.
struct Panels {
    SceneTree* tree = nullptr;
    PropertyPanel* properties = nullptr;
};

Panels placePanels(QMainWindow& window, const PanelNeeds& needs);

}  // namespace keyblock
