// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text, the same in every locale.
#pragma once

#include <string>

namespace keyblock {

/// Four digits, for people.
std::string rounded(double number);

/// A coordinate [m] to the millimetre, for people.
std::string coordinateText(double metres);

/// A stress or modulus with unit and prefix, for people.
std::string pressureText(double pascals);

/// The shortest text that reads back as the same double; `inf` and `nan` for what is not finite.
std::string shortest(double number);

}  // namespace keyblock
