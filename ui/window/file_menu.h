// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Entries of the menus File and Help that are not commands: recent scenes, and
// information about the program.
#pragma once

#include <functional>

class QMainWindow;
class QString;

namespace keyblock {

class RecentFiles;

/// Adds "Open recent" below Open and "About" at the end of Help. \pre the menus are filled. `open` gets a path.
void addToMenus(QMainWindow& window, const RecentFiles& recent, std::function<void(const QString&)> open);

}  // namespace keyblock
