// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run is opened with its scene: the scene file next to the store if it is unchanged,
// else the copy of the scene in the store.
#pragma once

#include "ui/window/file_commands.h"

namespace keyblock {

class Document;
class Runs;

/// Replaces the document, unless it already has the scene of the run, after asking about unsaved edits if the user was
/// not asked yet. A store that cannot be read leaves the document as it is; `runs` reports the error.
void openRun(Document& document, Runs& runs, const QString& store, QWidget& window, UnsavedEdits edits);

}  // namespace keyblock
