// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which build of the mechanics this is.
#pragma once

#include <string_view>

namespace keyblock {

/// Hexadecimal digits; the same in all programs of one build, another where the mechanics or its files are others.
std::string_view buildId();

}  // namespace keyblock
