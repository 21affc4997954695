// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON pointers (RFC 6901) say where in a scene something is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace keyblock {

/// The pointer to member `key` of what `parent` points to; `~` and `/` in the key are escaped.
std::string under(std::string_view parent, std::string_view key);

/// The pointer to element `index` of the list that `parent` points to.
std::string under(std::string_view parent, std::size_t index);

/// True when `pointer` is `ancestor` or leads to something inside it.
bool isWithin(std::string_view pointer, std::string_view ancestor);

}  // namespace keyblock
