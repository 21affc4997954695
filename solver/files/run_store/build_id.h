// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Identifies the build of the solver.
#pragma once

#include <string_view>

namespace keyblock {

/// Hexadecimal digits that are the same in all programs of a build and change whenever the code of the solver changes.
std::string_view buildId();

}  // namespace keyblock
