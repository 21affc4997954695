// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Import of drawings into the window's document.
#pragma once

class QMainWindow;
class QString;

namespace keyblock {

class Commands;
class Document;
class Themes;

void addImportCommands(QMainWindow& window, Commands& commands, Document& document, const Themes& themes);

/// Whether the file is a drawing or a list, by its extension.
bool isDrawing(const QString& path);

/// Previews the import of a drawing; the document changes once the user confirms.
void openImport(QMainWindow& window, Document& document, const Themes& themes, const QString& path);

}  // namespace keyblock
