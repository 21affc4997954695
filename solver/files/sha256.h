// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hash that names a scene: two stores came from the same scene exactly when
// their hashes agree.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

/// SHA-256 of the bytes as 64 hexadecimal digits (FIPS 180-4), the same as `sha256sum` prints.
std::string sha256(std::string_view bytes);

}  // namespace keyblock
