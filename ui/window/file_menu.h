// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Entries of the File and Help menus that are not commands: recent scenes, and
// information about the program.
#pragma once

#include <functional>

class QMainWindow;
class QString;

namespace keyblock {

class RecentFiles;

/// Adds "Open recent" below Open, and "About" at the end of the Help menu.
/// \param open called with the path of the chosen scene
/// \pre `fillMenus` has been called.
void addToMenus(QMainWindow& window, const RecentFiles& recent, std::function<void(const QString&)> open);

}  // namespace keyblock
