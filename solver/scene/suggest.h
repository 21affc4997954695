// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Suggests the right name for a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// `text` between single quotes; at most 60 characters of it.
std::string inQuotes(std::string_view text);

/// The names, quoted, with commas between; at most twelve of them. `none` when there are none.
std::string listed(const std::vector<std::string_view>& names);

/// The name that `text` was probably meant to be: few letters differ. Empty when none is near.
std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names);

/// A remedy: `Did you mean 'x'?` when a name is near, else what there is.
std::string suggestion(std::string_view text, const std::vector<std::string_view>& names);

}  // namespace keyblock
