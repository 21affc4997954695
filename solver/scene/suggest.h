// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Suggestions for mistyped names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// `text` in single quotes, shortened to 60 bytes.
std::string inQuotes(std::string_view text);

/// The names in quotes, separated by commas; at most twelve are included. `none` if there are no names.
std::string listed(const std::vector<std::string_view>& names);

/// The name that the user probably meant by `text`: one that differs from it in only a few letters; empty if there is
/// none.
std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names);

/// Text of a remedy: `Did you mean 'x'?` if a name is similar, otherwise the list of names.
std::string suggestion(std::string_view text, const std::vector<std::string_view>& names);

}  // namespace keyblock
