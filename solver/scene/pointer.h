// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON pointers (RFC 6901) to parts of a scene.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace keyblock {

/// Pointer to the member `key` of the object at `parent`; `~` and `/` in the key are escaped.
std::string under(std::string_view parent, std::string_view key);

/// Pointer to the element `index` of the list at `parent`.
std::string under(std::string_view parent, std::size_t index);

/// True if `pointer` is `ancestor` or points to something inside it.
bool isWithin(std::string_view pointer, std::string_view ancestor);

}  // namespace keyblock
