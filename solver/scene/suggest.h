// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Suggestions for mistyped names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// `text` in single quotes. If it is longer than 60 bytes, it is shortened to that length and ends with `…`.
std::string inQuotes(std::string_view text);

/// The names in quotes, separated by commas. After twelve names, `…` replaces the rest. `none` if there are no names.
std::string listed(const std::vector<std::string_view>& names);

/// The name that the user probably meant by `text`: one that differs from `text` in only a few letters or, if there is
/// none, one that starts with `text`. Empty if there is neither.
std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names);

/// Text of a remedy: `Did you mean 'x'?` if `nearestName` finds a name, otherwise the list of names. `None is defined`
/// if there are no names.
std::string suggestion(std::string_view text, const std::vector<std::string_view>& names);

}  // namespace keyblock
