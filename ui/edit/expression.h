// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Evaluates expressions typed into a number field: + − * / ^, brackets, functions, and
// angles in degrees. Numbers have a decimal point here; units and decimal commas must
// already have been converted.
#pragma once

#include <optional>
#include <string>

namespace keyblock {

/// The value of an expression, or an error message if it has no value.
struct ExpressionResult {
    std::optional<double> value;  // finite
    std::string problem;
};

/// Evaluates an expression such as `5/2+0.1`, `sqrt(2)*3`, `max(1, 2)` or `2*sin(30)`. Available names: sqrt, abs, min,
/// max, sin, cos, tan, asin, acos, atan (angles in degrees) and pi.
ExpressionResult evaluateExpression(const std::string& text);

}  // namespace keyblock
