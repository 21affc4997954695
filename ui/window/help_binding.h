// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Help, command palette and list of keyboard shortcuts of the window.
#pragma once

class QMainWindow;
class QWidget;

namespace keyblock {

class Commands;
class Themes;

/// Adds the commands that open the help (F1), the command palette (Ctrl+K) and the list of shortcuts (`?`), and the
/// dock that shows help. Returns the search box for the menu bar.
QWidget* addHelp(QMainWindow& window, Commands& commands, const Themes& themes);

}  // namespace keyblock
