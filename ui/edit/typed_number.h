// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number as typed by the user: with a decimal comma or point, with its own unit,
// or as an expression. Displayed numbers (true minus, thin spaces) can be typed
// back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// A number, or what is wrong with the text and what to type.
struct TypedNumber {
    std::optional<double> value;  // finite, in the requested unit
    std::string problem;  // a sentence; empty if there is a value
};

/// Reads `text` as a number in `unit`, the unit of a bare number (`m`, `MPa`, `°`, …; empty: a pure number):
/// `12,5`, `300mm`, `2.5 kN`, `=5/2+0.1`, `=2m + 300mm`. A unit in the text converts to `unit`.
TypedNumber typedNumber(std::string_view text, std::string_view unit);

/// The text without typography: true minus becomes '-', spaces inside numbers and at the ends are removed.
std::string plainNumberText(std::string_view text);

}  // namespace keyblock
