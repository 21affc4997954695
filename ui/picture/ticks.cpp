// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/ticks.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace keyblock {

namespace {

constexpr double tickRoundOff = 1e-9;
constexpr double largestShown = 1e100, smallestWidth = 1e-100;
constexpr int mostRounds = 100;  // steps that are tried; a few are enough

int decimalsOf(double step) {
    for (int decimals = 0; decimals < 12; ++decimals) {
        const double scaled = step * std::pow(10.0, decimals);
        if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) return decimals;
    }
    return 12;
}

double firstNotBelow(double least, std::initializer_list<double> factors) {
    if (!(least >= smallestWidth) || !canBeShown(least)) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : factors)
        if (factor * power >= least * (1.0 - tickRoundOff)) return factor * power;
    return 10.0 * power;
}

bool hasNoWidth(const ValueRange& range) {
    return range.high - range.low <= tickRoundOff * std::max(std::abs(range.low), std::abs(range.high));
}

/// The step after `step`, which is a little larger.
double nextStep(double step) { return roundStep(step * 1.01); }

}  // namespace

bool canBeShown(double value) { return std::abs(value) <= largestShown; }

double roundStep(double least) { return firstNotBelow(least, {1.0, 2.0, 2.5, 5.0}); }

double roundHalvable(double least) { return firstNotBelow(least, {1.0, 2.0, 5.0}); }

Ticks roundTicks(const ValueRange& range, int most) {
    assert(most >= 2);
    if (!canBeShown(range.low) || !canBeShown(range.high) || !(range.high - range.low > smallestWidth)) return {};
    const double width = range.high - range.low;
    double step = roundStep(width / most);
    const auto count = [&](double s) {
        return std::floor(range.high / s + tickRoundOff) - std::ceil(range.low / s - tickRoundOff) + 1.0;
    };
    for (int round = 0; count(step) > most && round < mostRounds; ++round) step = nextStep(step);
    Ticks ticks;
    ticks.decimals = decimalsOf(step);
    const double first = std::ceil(range.low / step - tickRoundOff);
    for (int i = 0; i < std::min(static_cast<int>(count(step)), most); ++i) ticks.values.push_back((first + i) * step);
    return ticks;
}

ValueRange roundedRange(const ValueRange& range, int most) {
    if (!canBeShown(range.low) || !canBeShown(range.high)) return {0.0, 1.0};
    ValueRange wide = range;
    if (hasNoWidth(wide)) wide = {std::min(wide.low, 0.0), std::max(wide.high, 0.0)};
    if (!(wide.high - wide.low > smallestWidth)) return {0.0, 1.0};
    const int intervals = std::max(most - 1, 1);
    double step = roundStep((wide.high - wide.low) / intervals);
    for (int round = 0; round < mostRounds; ++round, step = nextStep(step)) {
        const double low = std::floor(wide.low / step + tickRoundOff), high = std::ceil(wide.high / step - tickRoundOff);
        if (high - low <= intervals) return {low * step, high * step};
    }
    return wide;
}

ValueRange roundedSymmetric(const ValueRange& range, int most) {
    const double size = std::max(std::abs(range.low), std::abs(range.high));
    const double high = roundedRange({0.0, size}, (most + 1) / 2).high;
    return {-high, high};
}

ValueRange rangeWithout(std::vector<Weighed> values, double share) {
    std::erase_if(values, [](const Weighed& value) { return !canBeShown(value.value) || !canBeShown(value.weight); });
    if (values.empty()) return {};
    std::sort(values.begin(), values.end(), [](const Weighed& a, const Weighed& b) { return a.value < b.value; });
    double total = 0.0;
    for (const Weighed& value : values) total += value.weight;
    const auto past = [&](auto begin, auto end) {
        double sum = 0.0;
        for (auto at = begin; at != end; ++at)
            if ((sum += at->weight) > share * total) return at->value;
        return begin->value;
    };
    return {past(values.begin(), values.end()), past(values.rbegin(), values.rend())};
}

std::string numberText(double value, int decimals) {
    std::array<char, 400> buffer{};
    const double size = std::abs(value);
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), size, std::chars_format::fixed,
                                   std::min(decimals, 12)).ptr;
    const std::string plain(buffer.data(), end);
    const std::size_t whole = std::min(plain.find('.'), plain.size());
    std::string text;
    if (value < 0.0 && plain.find_first_not_of("0.") != std::string::npos) text = "−";
    for (std::size_t i = 0; i < plain.size(); ++i) {
        if (i > 0 && i < whole && whole > 4 && (whole - i) % 3 == 0) text += "\u2009";
        text += plain[i];
    }
    return text;
}

std::string numberText(double value) {
    if (value == 0.0 || !std::isfinite(value)) return value == 0.0 ? "0" : "–";
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(value))));
    if (magnitude < -4 || magnitude > 6) {
        const double mantissa = value / std::pow(10.0, magnitude);
        return numberText(mantissa, 1) + "·10^" + (magnitude < 0 ? "−" : "") + std::to_string(std::abs(magnitude));
    }
    std::string text = numberText(value, std::clamp(2 - magnitude, 0, 6));
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

}  // namespace keyblock
