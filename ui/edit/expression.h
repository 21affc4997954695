// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Expressions typed into a number field: + − * / ^, brackets, roots, and angles in
// degrees. Numbers have a decimal point here; units and commas were converted
// before.
#pragma once

#include <optional>
#include <string>

namespace keyblock {

/// A value, or why the text has none.
struct ExpressionResult {
    std::optional<double> value;  // finite
    std::string problem;
};

/// `5/2+0.1`, `sqrt(2)*3`, `max(1, 2)`, `2*sin(30)`. Names: sqrt, abs, min, max, sin, cos, tan, asin, acos, atan
/// (degrees), pi.
ExpressionResult evaluateExpression(const std::string& text);

}  // namespace keyblock
