// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The journal of edits as text: one line for the scene as it was opened, and one for
// each edit, undo and save since then. Lines are only appended. An edit is stored as
// the changed parts of the scene's text, so that even a thousand edits of a large scene
// need little space. Each line starts with a hash of the rest of the line, by which
// damage is detected. A last line without a line end was not written completely and is
// ignored.
#pragma once

#include "ui/document/text_changes.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct JournalStep {
    std::string name;  // name of the undo step; empty for the first scene
    bool isWhole = false;  // true: stores the whole text of the scene; false: changes of the previous text
    std::vector<TextChange> changes;
    std::size_t size = 0;  // size of the scene's text after this step [bytes]
};

/// Contents of a journal.
struct Journalled {
    std::string path;  // path of the scene file; empty: never saved
    std::string name;  // name of a document without a file
    std::vector<JournalStep> steps;  // the first is the scene as opened; empty: the journal is unusable
    std::size_t index = 0;  // index of the step that was current at the end
    std::optional<std::size_t> saved;  // index of the step that was saved last
    std::size_t changes = 0;  // number of edits, undos and redos
    std::size_t size = 0;  // size of the lines read [bytes]
    std::string damage;  // error message; empty: no damage
};

std::string journalBegin(const std::string& path, const std::string& name, const std::string& sceneText, bool isSaved);
/// Line for an edit: the scenes from `index` on are dropped from the undo stack, and a scene with the text `after` is
/// added at `index`. The line stores the differences from `before`, the text of the scene at `index` − 1.
std::string journalStep(std::size_t index, const std::string& name, std::string_view before, std::string_view after);
/// Like `journalStep`, but the line stores the whole text, so that the text of the previous scene is not needed.
std::string journalWholeStep(std::size_t index, const std::string& name, const std::string& after);
std::string journalMove(std::size_t index);
/// Line for a save of the scene at `index` on the undo stack. \param index null: the saved scene is not on the undo
/// stack.
std::string journalSaved(std::optional<std::size_t> index, const std::string& path);

/// Reads a journal up to the first damaged line. \param mostChanges maximum number of changes to read; null: all
Journalled readJournal(std::string_view text, std::optional<std::size_t> mostChanges = {});

/// The text of the scene after a step. \param before text before the step; not used if the step stores the whole text
std::string textAfter(const JournalStep& step, std::string_view before);

}  // namespace keyblock
