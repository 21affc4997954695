// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// New, open, save, and the commands of the window itself: undo, theme, units.
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

/// `open` gets the file that the user chooses: a scene, a run or a drawing. Asks about unsaved edits first.
void addFileCommands(Commands& commands, Document& document, QWidget& window, std::function<void(const QString&)> open);
void addEditCommands(Commands& commands, Document& document);
void addCanvasCommands(Commands& commands, Canvas& canvas);
void addViewCommands(Commands& commands, Themes& themes, Display& display);

/// Opens a scene file; asks first if unsaved edits would be lost. If it has errors, the readable part is opened, and
/// the document reports what is missing. \param edits whether the user has already been asked about them.
void openDocument(Document& document, const QString& path, QWidget& window, UnsavedEdits edits = UnsavedEdits::Ask);

/// True if the document is saved, was saved now, or the user discards the edits.
bool mayDiscard(Document& document, QWidget& window);

}  // namespace keyblock
