// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number as a person types it: with a decimal comma or point, with a unit of its
// own, or as a sum. What is shown (true minus, thin spaces) can be typed back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// A number, or what is wrong with the text and what to type.
struct TypedNumber {
    std::optional<double> value;  // finite, in the unit asked for
    std::string problem;  // a sentence; empty when there is a value
};

/// Reads `text` as a number in `unit`, the one that a bare number has (`m`, `MPa`, `°`, …; empty: a pure number):
/// `12,5`, `300mm`, `2.5 kN`, `=5/2+0.1`, `=2m + 300mm`. A unit in the text converts to `unit`.
TypedNumber typedNumber(std::string_view text, std::string_view unit);

/// The text without what only looks: true minus becomes '-', spaces inside numbers and at the ends go.
std::string plainNumberText(std::string_view text);

}  // namespace keyblock
