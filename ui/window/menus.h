// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Menus from the list of commands.
#pragma once

#include <vector>

class QMenuBar;
class QWidget;

namespace keyblock {

class Commands;

/// Fills the bar with File, Edit, View, Insert, Run, Results, Tools, Help; menus without commands are omitted, and
/// groups of commands are separated by lines.
void fillMenus(QMenuBar& bar, const Commands& commands);

/// Puts widgets at the right end of the bar.
void placeAtRight(QMenuBar& bar, const std::vector<QWidget*>& widgets);

}  // namespace keyblock
