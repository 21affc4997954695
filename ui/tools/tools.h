// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of all tools, their commands, and the selected bolts.
#pragma once

#include <memory>
#include <vector>

class QAction;

namespace keyblock {

class Commands;
class Tool;
class ToolDesk;
class ToolPalette;
class Workbench;

/// One instance of each tool; the select tool is first.
std::vector<std::unique_ptr<Tool>> makeAllTools(Workbench& bench);

/// Adds a command, its key and a palette button for each tool. Appends the commands to `actions`.
void addToolCommands(Commands& commands, ToolDesk& desk, ToolPalette& palette, std::vector<QAction*>& actions);

/// Adds the commands that switch object snap, ortho, grid and grid snap on and off.
void addModeCommands(Commands& commands, Workbench& bench);

/// The selected bolts and the bolts of selected patterns, as indices into the bolts of the cut scene.
std::vector<int> selectedBolts(const Workbench& bench);

}  // namespace keyblock
