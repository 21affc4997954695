// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Help, command palette and list of keyboard shortcuts in the window.
#pragma once

class QMainWindow;
class QWidget;

namespace keyblock {

class Commands;
class Themes;

/// Adds F1, Ctrl+K and `?`, and the dock in which help opens. Returns the search box for the menu bar.
QWidget* addHelp(QMainWindow& window, Commands& commands, const Themes& themes);

}  // namespace keyblock
