// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Opens a run together with its scene: from the scene file next to the run store if the
// file is unchanged, otherwise from the copy in the store.
#pragma once

#include "ui/window/file_commands.h"

namespace keyblock {

class Document;
class Runs;

/// Replaces the document with the scene of the run, unless it already has this scene, and shows the run. If the store
/// cannot be read, `runs` reports the error and the document stays unchanged.
/// \param edits `Ask`, or `Settled` if the user has been asked about unsaved edits already
void openRun(Document& document, Runs& runs, const QString& store, QWidget& window, UnsavedEdits edits);

}  // namespace keyblock
