// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers as text, independent of the locale.
#pragma once

#include <string>

namespace keyblock {

/// The number with four significant digits, for display.
std::string rounded(double number);

/// A coordinate in metres, rounded to the millimetre, for display. The text does not include the unit.
std::string coordinateText(double metres);

/// A length with four significant digits, in m, mm or µm, or "less than 1 nm" if it is only round-off, for display.
std::string lengthText(double metres);

/// An area with four significant digits, in m², cm² or mm², for display.
std::string areaText(double squareMetres);

/// A stress or modulus with four significant digits, followed by its unit (Pa, kPa, MPa or GPa), for display.
std::string pressureText(double pascals);

/// The shortest text that is read back as the same double; `inf`, `-inf` or `nan` if the number is not finite.
std::string shortest(double number);

}  // namespace keyblock
