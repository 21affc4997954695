// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Help, palette and key sheet in the window.
#pragma once

class QMainWindow;
class QWidget;

namespace keyblock {

class Commands;
class Themes;

/// Adds F1, Ctrl+K and `?`, and the dock that help opens in. Gives the search box, for the menu bar.
QWidget* addHelp(QMainWindow& window, Commands& commands, const Themes& themes);

}  // namespace keyblock
