// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hash that identifies a scene: two stores are from the same scene if and only if
// their hashes agree.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace keyblock {

/// SHA-256 of the bytes (FIPS 180-4) as 64 hexadecimal digits, as printed by `sha256sum`.
std::string sha256(std::string_view bytes);

/// SHA-256 of the contents of a file of any size, in the same form. \throws CannotRead if it is not a regular file or
/// cannot be read.
std::string sha256OfFile(const std::filesystem::path& path);

}  // namespace keyblock
