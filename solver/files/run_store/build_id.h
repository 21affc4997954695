// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Identifies the build of the solver.
#pragma once

#include <string_view>

namespace keyblock {

/// Build identifier in hexadecimal digits. It is the same in all programs of a build and changes whenever the code of
/// the solver changes.
std::string_view buildId();

}  // namespace keyblock
