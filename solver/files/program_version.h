// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program's version is said once, in the build's project line.
#pragma once

#include <string_view>

namespace keyblock {

/// As in `0.1.0`.
std::string_view programVersion();

}  // namespace keyblock
