// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run is opened with its scene: the scene file next to the store if it is still
// the same, else the copy of the scene that the store holds.
#pragma once

#include "ui/window/file_commands.h"

namespace keyblock {

class Document;
class Runs;

/// Replaces the document, after asking if it has unsaved edits that the user was not asked about, unless it holds the scene of the run already. A store
/// that cannot be read leaves the document as it is; `runs` reports the error.
void openRun(Document& document, Runs& runs, const QString& store, QWidget& window, UnsavedEdits edits);

}  // namespace keyblock
