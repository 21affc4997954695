// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/convergence.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double noEffect = 1e-6;  // change over the value: smaller ones do not show how a quantity converges
constexpr double ofTheory = 2.0;  // factor on the orders of theory within which one is plausible
constexpr int bisections = 60;

/// Ratio of the differences of three values whose error is a power of the size. It grows with the order.
double ratioAt(double order, std::span<const SizedValue> values) {
    const double fine = std::pow(values[1].size / values[0].size, order);
    const double coarse = std::pow(values[2].size / values[1].size, order);
    return fine * (coarse - 1.0) / (fine - 1.0);
}

double orderOf(double ratio, double low, double high, std::span<const SizedValue> values) {
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (low + high);
        (ratioAt(middle, values) < ratio ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double rangeOf(std::span<const SizedValue> values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end(),
                                                 [](const auto& a, const auto& b) { return a.value < b.value; });
    return high->value - low->value;
}

}  // namespace

ConvergenceOrder convergenceOf(std::span<const SizedValue> values, TheoreticalOrders theory) {
    using Kind = ConvergenceOrder::Kind;
    if (values.size() < 3) return {};
    const std::span<const SizedValue> finest = values.first(3);
    const double fine = finest[0].value - finest[1].value, coarse = finest[1].value - finest[2].value;
    const double scale = std::max(std::abs(finest[0].value), std::abs(finest[2].value));
    if (std::max(std::abs(fine), std::abs(coarse)) <= noEffect * scale) return {Kind::NoEffect};
    const bool oneSign = fine * coarse > 0.0 &&
                         (values.size() < 4 || fine * (finest[2].value - values[3].value) >= 0.0);
    const double low = theory.lowest / ofTheory, high = theory.highest * ofTheory, ratio = coarse / fine;
    if (oneSign && ratio >= ratioAt(low, finest) && ratio <= ratioAt(high, finest)) {
        const double order = orderOf(ratio, low, high, finest);
        return {Kind::Regular, order,
                finest[0].value + fine / (std::pow(finest[1].size / finest[0].size, order) - 1.0)};
    }
    return {Kind::Irregular, 0.0, 0.0, rangeOf(finest)};
}

}  // namespace keyblock
