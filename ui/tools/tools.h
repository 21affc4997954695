// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of all tools, their commands, and the bolts in the selection.
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

/// One instance of each tool, Select first.
std::vector<std::unique_ptr<Tool>> makeAllTools(Workbench& bench);

/// A command, a key and a button for each tool.
void addToolCommands(Commands& commands, ToolDesk& desk, ToolPalette& palette, std::vector<QAction*>& actions);

/// Object snap, ortho, grid and grid snap.
void addModeCommands(Commands& commands, Workbench& bench);

/// Rows of the bolts of the cut scene that belong to the selected bolts and patterns.
std::vector<int> selectedBolts(const Workbench& bench);

}  // namespace keyblock
