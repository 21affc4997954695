// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Import of drawings into the document of the window.
#pragma once

class QMainWindow;
class QString;

namespace keyblock {

class Commands;
class Document;
class Themes;

void addImportCommands(QMainWindow& window, Commands& commands, Document& document, const Themes& themes);

/// True if the extension of the file is that of a drawing (.dxf) or a list (.csv), both of which can be imported.
bool isDrawing(const QString& path);

/// Opens the import preview for a drawing. The document changes only when the user confirms.
void openImport(QMainWindow& window, Document& document, const Themes& themes, const QString& path);

}  // namespace keyblock
