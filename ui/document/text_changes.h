// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What differs between two texts, as stretches of lines with what stands in their
// place, so that an edit in two far corners of a large scene stays as small as it is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// A stretch of a text and what comes in its place.
struct TextChange {
    std::size_t begin = 0, removed = 0;  // in the text before [bytes]
    std::string text;
};

/// What makes `after` of `before`, from the front, none upon another. Letters of UTF-8 stay whole. Not always the least
/// there is, but found in a time that grows with the texts' lengths.
std::vector<TextChange> textChanges(std::string_view before, std::string_view after);

/// Whether they stand in order within a text of that length.
bool areWithin(const std::vector<TextChange>& changes, std::size_t length);

/// \pre `areWithin` the text before.
std::string changed(std::string_view before, const std::vector<TextChange>& changes);

}  // namespace keyblock
