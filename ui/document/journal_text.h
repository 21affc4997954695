// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The journal of edits as text: a line for the scene as it was opened and one for
// each edit, undo and save since. Lines are only appended. An edit is stored as the
// changed parts of the scene's text, so that a thousand edits of a large scene stay
// small. Each line starts with a hash of the rest to detect damage; a last line
// without an end was not written completely and is ignored.
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
    bool isWhole = false;  // the whole text of the scene, as for the first; else changes of the previous one
    std::vector<TextChange> changes;
    std::size_t size = 0;  // size of the scene's text after it [bytes]
};

/// Contents of a journal.
struct Journalled {
    std::string path;  // of the scene's file; empty: never saved
    std::string name;  // shown if it has no file
    std::vector<JournalStep> steps;  // the first is the scene as it was opened; empty: the journal is unusable
    std::size_t index = 0;  // of the current step at the end
    std::optional<std::size_t> saved;  // index of the saved step
    std::size_t changes = 0;  // edits, undos and redos
    std::size_t size = 0;  // of the lines read [bytes]
    std::string damage;  // error message for the user; empty: none
};

std::string journalBegin(const std::string& path, const std::string& name, const std::string& sceneText, bool isSaved);
/// The scene at `index` is now `after`, and it is the last one.
std::string journalStep(std::size_t index, const std::string& name, std::string_view before, std::string_view after);
/// The same if the text of the previous scene is unknown to a reader.
std::string journalWholeStep(std::size_t index, const std::string& name, const std::string& after);
std::string journalMove(std::size_t index);
/// The scene at `index` was saved, or none of them.
std::string journalSaved(std::optional<std::size_t> index, const std::string& path);

/// Reads a journal up to the first damaged line, or up to so many changes.
Journalled readJournal(std::string_view text, std::optional<std::size_t> mostChanges = {});

/// The scene's text after a step. \param before the text of the previous step; unused if the step has the whole text.
std::string textAfter(const JournalStep& step, std::string_view before);

}  // namespace keyblock
