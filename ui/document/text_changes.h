// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The difference between two texts as a list of replaced ranges of lines, so that an
// edit at two distant positions of a large scene is stored compactly.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// A range of bytes in a text, and the text that replaces it.
struct TextChange {
    std::size_t begin = 0, removed = 0;  // range in the old text [bytes]
    std::string text;
};

/// The changes that turn `before` into `after`, sorted by position and without overlaps. UTF-8 characters are never
/// split. There may be more changes than necessary, but the time needed is proportional to the length of the texts.
std::vector<TextChange> textChanges(std::string_view before, std::string_view after);

/// True if the changes are sorted by position, do not overlap and lie within a text of `length` bytes.
bool areWithin(const std::vector<TextChange>& changes, std::size_t length);

/// Applies the changes to `before`. \pre `areWithin(changes, before.size())`
std::string changed(std::string_view before, const std::vector<TextChange>& changes);

}  // namespace keyblock
