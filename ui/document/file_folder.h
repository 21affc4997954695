// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The initial folder of dialogs for scenes and drawings: that of the document or, if it
// has no file, the last one used. Exports to other folders do not change it.
#pragma once

#include <QString>

namespace keyblock {

class Document;

QString fileFolder(const Document& document);

/// Remembers the folder of a chosen file.
void rememberFolderOf(const QString& path);

}  // namespace keyblock
