// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as other programs write them into text files.
#pragma once

#include <string_view>

namespace keyblock {

/// A whole text that is a finite number below 1e15; a leading `+` is allowed. \return false where it is none.
bool readReal(std::string_view text, double& number);

/// The same for an integer.
bool readInteger(std::string_view text, int& number);

}  // namespace keyblock
