// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The version of the program, which is defined only in the `project` command of the
// build.
#pragma once

#include <string_view>

namespace keyblock {

/// Version of the program, e.g. `0.1.0`.
std::string_view programVersion();

}  // namespace keyblock
