// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/change_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keyblock {

namespace {

constexpr double leastChangeTold = 1e-5, changeInTimes = 10.0, mostTimesTold = 1000.0;
constexpr double leastPlain = 1e-3, mostPlain = 1e6;  // without an exponent from the one to the other
constexpr int digitsTold = 3;

std::string formatted(double number, std::chars_format format, int digits) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format, digits);
    return {text.data(), end.ptr};
}

/// Places after the point, of which the last is the third significant digit; negative left of the point.
int placesOf(double size) { return digitsTold - 1 - static_cast<int>(std::floor(std::log10(size))); }

}  // namespace

std::string threeDigits(double number) {
    const double size = std::abs(number);
    if (!(size >= leastPlain && size < mostPlain)) return formatted(number, std::chars_format::general, digitsTold);
    const std::string scientific = formatted(number, std::chars_format::scientific, digitsTold - 1);
    double cut = number;
    std::from_chars(scientific.data(), scientific.data() + scientific.size(), cut);
    std::string text = formatted(cut, std::chars_format::fixed, std::max(0, placesOf(std::abs(cut))));
    if (text.find('.') == std::string::npos) return text;
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

std::string changeText(double change) {
    const double size = std::abs(change);
    if (!std::isfinite(size)) return "–";
    if (size > mostTimesTold) return "more than " + threeDigits(mostTimesTold) + " ×";
    if (size >= changeInTimes) return timesText(size);
    if (size > 0.0 && size < leastChangeTold) return "less than " + threeDigits(100.0 * leastChangeTold) + " %";
    return threeDigits(100.0 * size) + " %";
}

std::string signedChangeText(double change) {
    const double size = std::abs(change);
    if (size < leastChangeTold) return changeText(size);
    if (size > mostTimesTold) return "changed by " + changeText(size);
    return (change > 0.0 ? "+" : "−") + changeText(change);
}

std::string timesText(double ratio) {
    return ratio > mostTimesTold ? "more than " + threeDigits(mostTimesTold) + " ×" : threeDigits(ratio) + " ×";
}

}  // namespace keyblock
