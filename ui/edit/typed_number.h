// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a number as typed by the user: with a decimal comma or point, with its own
// unit, or as an expression. The text of a displayed number, with a true minus sign and
// thin spaces, can be entered again.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// A number, or a message that says what is wrong with the text and what to enter.
struct TypedNumber {
    std::optional<double> value;  // finite, in the requested unit
    std::string problem;  // a sentence; empty if there is a value
};

/// Reads a number such as `12,5`, `300mm`, `2.5 kN`, `=5/2+0.1` or `=2m + 300mm`. Numbers with a unit of the same kind
/// are converted to `unit`.
/// \param unit unit of the result, and of numbers typed without a unit (`m`, `MPa`, `°`, …; empty: dimensionless).
TypedNumber typedNumber(std::string_view text, std::string_view unit);

/// Converts the text of a number to plain characters: true minus signs are replaced by '-', and spaces at the ends and
/// between thousands are removed.
std::string plainNumberText(std::string_view text);

}  // namespace keyblock
