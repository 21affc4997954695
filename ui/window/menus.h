// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the menus from the list of commands.
#pragma once

#include <vector>

class QMenuBar;
class QWidget;

namespace keyblock {

class Commands;

/// Fills the menu bar with File, Edit, View, Insert, Run, Results, Tools and Help. Menus without commands are left out;
/// separators divide groups of commands.
void fillMenus(QMenuBar& bar, const Commands& commands);

/// Places widgets at the right end of the menu bar.
void placeAtRight(QMenuBar& bar, const std::vector<QWidget*>& widgets);

}  // namespace keyblock
