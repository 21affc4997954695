// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes of quantities and ratios of times in sentences and tables for people: three
// significant digits, and words where a number is too large to mean more.
#pragma once

#include <string>

namespace keyblock {

/// The number with three significant digits, without an exponent from 0.001 up to a million.
std::string threeDigits(double number);

/// A relative change, such as 0.0123, without a sign: `1.23 %`, from tenfold `46.1 ×`, `less than 0.001 %` or
/// `more than 1000 ×`; `–` if it is not finite.
std::string changeText(double change);

/// The same with `+` or `−` before it, unless it is too small; `changed by more than 1000 ×` if it is too large.
std::string signedChangeText(double change);

/// A ratio of times: `1.59 ×`, or `more than 1000 ×`.
std::string timesText(double ratio);

}  // namespace keyblock
