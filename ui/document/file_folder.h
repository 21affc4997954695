// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The folder in which dialogs for scenes and drawings begin: that of the document,
// else the one used last; exports in between do not count.
#pragma once

#include <QString>

namespace keyblock {

class Document;

QString fileFolder(const Document& document);

/// Remembers the folder of a file that was chosen.
void rememberFolderOf(const QString& path);

}  // namespace keyblock
