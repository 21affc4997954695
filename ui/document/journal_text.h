// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The journal of edits as text: a line for the scene as it was opened and one for
// each edit, undo and save since, only ever appended. An edit is told by the
// stretches of the scene's text that it changes, so that a thousand edits of a large
// scene stay small. Each line begins with a hash of the
// rest, so that damage is seen; a last line without an end was cut off while it
// was written and counts as never written.
#pragma once

#include "ui/document/text_changes.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct JournalStep {
    std::string name;  // as undo calls it; of the first scene empty
    bool isWhole = false;  // the scene's text is told whole, as of the first; else by what changes in the one before
    std::vector<TextChange> changes;
    std::size_t size = 0;  // of the scene's text after it [bytes]
};

/// What a journal tells.
struct Journalled {
    std::string path;  // of the scene's file; empty: never saved
    std::string name;  // shown while it has no file
    std::vector<JournalStep> steps;  // the first is the scene as it was opened; empty: the journal is not to be used
    std::size_t index = 0;  // of the step that stood at the end
    std::optional<std::size_t> saved;  // the one that the file holds
    std::size_t changes = 0;  // edits, undos and redos
    std::size_t size = 0;  // of the lines that tell all this [bytes]
    std::string damage;  // what is wrong with it, for people; empty: nothing
};

std::string journalBegin(const std::string& path, const std::string& name, const std::string& sceneText, bool isSaved);
/// The scene at `index` is now `after`, and there is none behind it.
std::string journalStep(std::size_t index, const std::string& name, std::string_view before, std::string_view after);
/// The same where it is not known how a reader has the scene before.
std::string journalWholeStep(std::size_t index, const std::string& name, const std::string& after);
std::string journalMove(std::size_t index);
/// The file holds the scene at `index`, or none of them.
std::string journalSaved(std::optional<std::size_t> index, const std::string& path);

/// Reads a journal as far as it is whole, or up to so many changes.
Journalled readJournal(std::string_view text, std::optional<std::size_t> mostChanges = {});

/// The scene's text after a step. \param before the one of the step before; of no matter where the step tells it whole.
std::string textAfter(const JournalStep& step, std::string_view before);

}  // namespace keyblock
