// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only file that uses muParser. muParser also accepts comparisons, assignments
// and lists, so the characters are checked first.
#include "ui/edit/expression.h"

#include <muParser.h>

#include <cmath>
#include <string_view>

namespace keyblock {
namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

double sine(double angle) { return std::sin(angle * degree); }
double cosine(double angle) { return std::cos(angle * degree); }
double tangent(double angle) { return std::tan(angle * degree); }
double arcSine(double value) { return std::asin(value) / degree; }
double arcCosine(double value) { return std::acos(value) / degree; }
double arcTangent(double value) { return std::atan(value) / degree; }
double root(double value) { return std::sqrt(value); }
double size(double value) { return std::abs(value); }
double least(const double* values, int count) {
    double found = values[0];
    for (int i = 1; i < count; ++i) found = std::fmin(found, values[i]);
    return found;
}
double most(const double* values, int count) {
    double found = values[0];
    for (int i = 1; i < count; ++i) found = std::fmax(found, values[i]);
    return found;
}

void prepare(mu::Parser& parser) {
    parser.ClearConst();
    parser.ClearFun();
    parser.DefineConst("pi", 180.0 * degree);
    parser.DefineFun("sqrt", root);
    parser.DefineFun("abs", size);
    parser.DefineFun("min", least);
    parser.DefineFun("max", most);
    parser.DefineFun("sin", sine);
    parser.DefineFun("cos", cosine);
    parser.DefineFun("tan", tangent);
    parser.DefineFun("asin", arcSine);
    parser.DefineFun("acos", arcCosine);
    parser.DefineFun("atan", arcTangent);
}

/// The first character not allowed in an expression; none if all are allowed.
std::optional<std::string> strangeCharacter(const std::string& text) {
    constexpr std::string_view allowed = "0123456789.+-*/^(), \tabcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    const std::size_t at = text.find_first_not_of(allowed);
    if (at == std::string::npos) return std::nullopt;
    std::size_t end = at + 1;  // include all bytes of a multi-byte character
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) ++end;
    return text.substr(at, end - at);
}

/// True if a comma is outside the brackets of a function.
bool hasLooseComma(const std::string& text) {
    int depth = 0;
    for (const char c : text) {
        if (c == '(') ++depth;
        if (c == ')') --depth;
        if (c == ',' && depth == 0) return true;
    }
    return false;
}

std::string reasonOf(const mu::Parser::exception_type& error) {
    using enum mu::EErrorCodes;
    switch (error.GetCode()) {
        case ecMISSING_PARENS: return "A bracket is not closed.";
        case ecUNEXPECTED_PARENS: return "There is one bracket too many.";
        case ecUNEXPECTED_EOF:
        case ecEMPTY_EXPRESSION: return "The expression is incomplete.";
        case ecTOO_MANY_PARAMS:
        case ecTOO_FEW_PARAMS: return "A function has too few or too many numbers in its brackets.";
        case ecUNASSIGNABLE_TOKEN:
            return "'" + error.GetToken() + "' is not a known name. Use sqrt, abs, min, max, sin, cos, tan, asin, "
                   "acos, atan or pi.";
        default: break;
    }
    return "'" + error.GetToken() + "' is not allowed there.";
}

}  // namespace

ExpressionResult evaluateExpression(const std::string& text) {
    if (const auto strange = strangeCharacter(text)) return {{}, "'" + *strange + "' is not allowed in an expression."};
    if (hasLooseComma(text)) return {{}, "In an expression, use a decimal point: 2.5 + 1."};
    try {
        mu::Parser parser;
        prepare(parser);
        parser.SetExpr(text);
        const double value = parser.Eval();
        if (!std::isfinite(value)) return {{}, "The expression has no finite value."};
        return {value, {}};
    } catch (const mu::Parser::exception_type& error) {
        return {{}, reasonOf(error)};
    }
}

}  // namespace keyblock
