// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads numbers from text files of other programs.
#pragma once

#include <string_view>

namespace keyblock {

/// Reads text that consists of a single number with a magnitude below 1e15; a leading `+` is allowed.
/// \return false if the text is not such a number.
bool readReal(std::string_view text, double& number);

/// Reads text that consists of a single integer; a leading `+` is allowed.
/// \return false if the text is not an integer.
bool readInteger(std::string_view text, int& number);

}  // namespace keyblock
