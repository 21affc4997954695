// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A text is split into numbers, each with its unit, and the operators between
// them. Every number is converted to the unit of the field. A single number is
// the result; several with operators between them are an expression.
#include "ui/edit/typed_number.h"

#include "solver/scene/number_text.h"
#include "solver/scene/units.h"
#include "ui/edit/expression.h"

#include <cctype>
#include <charconv>
#include <cmath>

namespace keyblock {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool isPartOfSymbol(char c) { return isLetter(c) || c == '%' || static_cast<unsigned char>(c) >= 0x80u; }

std::string replaced(std::string text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// True for the space in `12 500`. \pre 0 < at.
bool separatesThousands(std::string_view text, std::size_t at) {
    if (text[at] != ' ' || !isDigit(text[at - 1]) || at + 3 >= text.size()) return false;
    const bool three = isDigit(text[at + 1]) && isDigit(text[at + 2]) && isDigit(text[at + 3]);
    return three && (at + 4 == text.size() || !isDigit(text[at + 4]));
}

/// Length in bytes of the number at `at`, which may have a decimal point or comma and an exponent.
std::size_t numberLength(std::string_view text, std::size_t at, bool commaToo) {
    std::size_t end = at;
    bool point = false;
    while (end < text.size() && (isDigit(text[end]) || (!point && (text[end] == '.' || (commaToo && text[end] == ','))))) {
        point = point || !isDigit(text[end]);
        ++end;
    }
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        std::size_t digits = end + 1;
        if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
        if (digits < text.size() && isDigit(text[digits])) {
            end = digits;
            while (end < text.size() && isDigit(text[end])) ++end;
        }
    }
    return end - at;
}

/// Length in bytes of the unit at `at`: letters and symbols; `/` and `·` belong to it only if more of the unit follows.
std::size_t unitLength(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size()) {
        const bool joins = text[end] == '/' && end > at && end + 1 < text.size() && isPartOfSymbol(text[end + 1]);
        const bool raises = end > at && ((isDigit(text[end]) && isPartOfSymbol(text[end - 1])) ||
                                         (text[end] == '^' && end + 1 < text.size() && isDigit(text[end + 1])) ||
                                         (isDigit(text[end]) && text[end - 1] == '^'));
        if (!isPartOfSymbol(text[end]) && !joins && !raises) break;
        ++end;
    }
    return end - at;
}

/// Reads the text and converts it to one unit.
class Reader {
public:
    Reader(std::string_view text, std::string_view unit) : text_(text), unitText_(unit), unit_(readUnit(unit)) {}

    TypedNumber read() {
        const bool sum = text_.starts_with("=") || hasSigns();
        if (text_.starts_with("=")) ++at_;
        while (at_ < text_.size() && problem_.empty()) next(sum);
        if (problem_.empty() && out_.empty()) problem_ = "Enter a number.";
        if (!problem_.empty()) return {{}, problem_};
        if (sum) {
            ExpressionResult result = evaluateExpression(out_);
            return {result.value, std::move(result.problem)};
        }
        return single();
    }

private:
    /// True if there is an operator besides the sign of the number and of its exponent.
    bool hasSigns() const {
        for (std::size_t i = 1; i < text_.size(); ++i) {
            const char c = text_[i];
            if (c == '*' || c == '(' || c == ')') return true;
            if ((c == '+' || c == '-') && !((text_[i - 1] == 'e' || text_[i - 1] == 'E') && i + 1 < text_.size() &&
                                            isDigit(text_[i + 1]) && i >= 2 && isDigit(text_[i - 2])))
                return true;
            if ((c == '/' || c == '^') && !(c == '/' && i + 1 < text_.size() && isPartOfSymbol(text_[i + 1])) &&
                !(c == '^' && isPartOfSymbol(text_[i - 1])))
                return true;
        }
        return false;
    }

    void next(bool sum) {
        const char c = text_[at_];
        if (isDigit(c) || ((c == '.' || (c == ',' && !sum)) && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])))
            return number(sum);
        if (c == ')' && sum) {
            out_ += c;
            ++at_;
            return unitBehindBracket();
        }
        if (isLetter(c) && sum) {
            while (at_ < text_.size() && (isLetter(text_[at_]) || text_[at_] == '_')) out_ += text_[at_++];
            return;
        }
        out_ += c;
        ++at_;
    }

    void number(bool sum) {
        const std::size_t length = numberLength(text_, at_, !sum);
        const std::string digits = replaced(std::string(text_.substr(at_, length)), ",", ".");
        at_ += length;
        double value = 0.0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value)) {
            problem_ = "'" + digits + "' is not a valid number.";
            return;
        }
        skipSpaces();
        if (const auto unit = takeUnit()) value = converted(value, *unit, *unit_);
        const std::string inUnit = shortest(value);
        out_ += inUnit.find_first_of("eE") == std::string::npos ? inUnit : "(" + inUnit + ")";
        ++numbers_;
    }

    void unitBehindBracket() {
        skipSpaces();
        if (const auto unit = takeUnit()) out_ += "*" + shortest(converted(1.0, *unit, *unit_));
    }

    void skipSpaces() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }

    /// The unit at this position; none if there is no unit or if it is wrong, in which case `problem_` is set.
    std::optional<Unit> takeUnit() {
        const std::size_t length = unitLength(text_, at_);
        if (length == 0) return std::nullopt;
        const std::string typed(text_.substr(at_, length));
        at_ += length;
        std::optional<Unit> unit = readUnit(typed);
        if (unit && unit_ && typed == "g" && unit_->powers == std::array<int, 4>{1, 0, -2, 0})
            unit = Unit{9.80665, 1.0, unit_->powers};  // g as an acceleration, not grams
        if (unit && unit_ && sameKind(*unit, *unit_)) return unit;
        problem_ = wrongUnit(typed, unit.has_value());
        return std::nullopt;
    }

    std::string wrongUnit(const std::string& typed, bool known) const {
        const std::string kind = unit_ ? kindText(*unit_) : "";
        const std::string wanted = kind.empty() ? "a number" + (unitText_.empty() ? "" : " in " + std::string(unitText_))
                                                : kind;
        return known ? "'" + typed + "' is the wrong kind of unit. Enter " + wanted + "."
                     : "'" + typed + "' is not a known unit. Enter " + wanted + ".";
    }

    /// Reads a single number. \pre the text is not an expression.
    TypedNumber single() {
        std::string_view digits = out_;
        if (digits.starts_with("(")) digits = digits.substr(1, digits.size() - 2);
        std::string text(digits);
        if (text.starts_with("+")) text.erase(0, 1);
        text = replaced(replaced(std::move(text), "-(", "-"), ")", "");
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (numbers_ == 1 && error == std::errc{} && end == text.data() + text.size()) return {value, {}};
        return {{}, "'" + std::string(text_) + "' is not a valid number. Enter one such as 2.5, 300mm or =5/2+0.1."};
    }

    std::string_view text_;
    std::string_view unitText_;
    std::optional<Unit> unit_;
    std::size_t at_ = 0;
    std::string out_;
    int numbers_ = 0;
    std::string problem_;
};

}  // namespace

std::string plainNumberText(std::string_view text) {
    std::string plain(text);
    for (const std::string_view minus : {"−", "–", "‐"})
        if (plain.starts_with(minus) || minus == "−") plain = replaced(std::move(plain), minus, "-");
    for (const std::string_view space : {"\u2009", "\u202F", "\u00A0"}) plain = replaced(std::move(plain), space, " ");
    plain = replaced(replaced(std::move(plain), "×", "*"), "÷", "/");
    for (std::size_t i = 1; i + 3 < plain.size();)
        if (separatesThousands(plain, i))
            plain.erase(i, 1);
        else
            ++i;
    const auto notSpace = [](char c) { return !std::isspace(static_cast<unsigned char>(c)); };
    while (!plain.empty() && !notSpace(plain.back())) plain.pop_back();
    while (!plain.empty() && !notSpace(plain.front())) plain.erase(0, 1);
    return plain;
}

TypedNumber typedNumber(std::string_view text, std::string_view unit) {
    const std::string plain = plainNumberText(text);
    return Reader(plain, unit).read();
}

}  // namespace keyblock
