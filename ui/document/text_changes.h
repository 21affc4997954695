// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The difference of two texts as replaced ranges of lines, so that an edit at two
// distant positions of a large scene is stored compactly.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// A range of a text and its replacement.
struct TextChange {
    std::size_t begin = 0, removed = 0;  // in the old text [bytes]
    std::string text;
};

/// The changes from `before` to `after`, in order and without overlap. UTF-8 characters stay whole. Not always the
/// smallest set, but found in time proportional to the length of the texts.
std::vector<TextChange> textChanges(std::string_view before, std::string_view after);

/// True if they are in order and within a text of that length.
bool areWithin(const std::vector<TextChange>& changes, std::size_t length);

/// \pre `areWithin` the old text.
std::string changed(std::string_view before, const std::vector<TextChange>& changes);

}  // namespace keyblock
