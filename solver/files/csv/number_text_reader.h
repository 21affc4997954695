// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads numbers from text files of other programs.
#pragma once

#include <string_view>

namespace keyblock {

/// Reads a number with a magnitude below 1e15. `text` must contain nothing else; a leading `+` is allowed.
/// \return false if `text` is not such a number.
bool readReal(std::string_view text, double& number);

/// Reads an integer. `text` must contain nothing else; a leading `+` is allowed.
/// \return false if `text` is not an integer.
bool readInteger(std::string_view text, int& number);

}  // namespace keyblock
