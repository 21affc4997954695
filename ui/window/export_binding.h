// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands that export the current view as figures, tables and animations.
#pragma once

class QMainWindow;

namespace keyblock {

class BoltChoice;
class Canvas;
class Commands;
class Themes;
class TimeCursor;
class ViewSettings;

/// Adds the commands export.figure, export.table, export.film and export.all.
void addExportCommands(QMainWindow& window, Commands& commands, const Themes& themes, const TimeCursor& cursor,
                       const BoltChoice& choice, const ViewSettings& view, const Canvas& canvas);

}  // namespace keyblock
