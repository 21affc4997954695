// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands New, Open and Save, and those of the window itself: undo, theme and
// units.
#pragma once

#include <functional>

class QString;
class QWidget;

namespace keyblock {

class Canvas;
class Commands;
class Display;
class Document;
class Themes;

enum class UnsavedEdits { Ask, Settled };

/// Adds the commands that create, open, save and revert scenes, and Quit. New and Open ask about unsaved edits first.
/// \param open called with the file that the user chooses: a scene, a run or a drawing
void addFileCommands(Commands& commands, Document& document, QWidget& window, std::function<void(const QString&)> open);
void addEditCommands(Commands& commands, Document& document);
void addCanvasCommands(Commands& commands, Canvas& canvas);
void addViewCommands(Commands& commands, Themes& themes, Display& display);

/// Opens a scene file, after asking about unsaved edits. If the file has errors, the part that can be read is opened,
/// and the document reports what is missing.
/// \param edits `Ask`, or `Settled` if the user has been asked about unsaved edits already
void openDocument(Document& document, const QString& path, QWidget& window, UnsavedEdits edits = UnsavedEdits::Ask);

/// Asks the user what to do with unsaved edits, if there are any. Returns false only if the user cancels or saving
/// fails.
bool mayDiscard(Document& document, QWidget& window);

}  // namespace keyblock
