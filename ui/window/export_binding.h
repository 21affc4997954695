// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exports what is on the screen as figures, tables and animations.
#pragma once

class QMainWindow;

namespace keyblock {

class BoltChoice;
class Canvas;
class Commands;
class Themes;
class TimeCursor;
class ViewSettings;

/// Adds export.figure, export.table, export.film and export.all.
void addExportCommands(QMainWindow& window, Commands& commands, const Themes& themes, const TimeCursor& cursor,
                       const BoltChoice& choice, const ViewSettings& view, const Canvas& canvas);

}  // namespace keyblock
