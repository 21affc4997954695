// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round numbers for axes, legends and scale bars, and how numbers are written for
// people: a true minus sign, thin spaces between thousands, as many decimals as
// the step needs.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct ValueRange {
    double low = 0.0, high = 0.0;

    bool operator==(const ValueRange&) const = default;
};

/// The smallest of 1, 2, 2.5 and 5 times a power of ten that is not below `least`. \pre least > 0
double roundStep(double least);

/// The smallest of 1, 2 and 5 times a power of ten that is not below `least`. \pre least > 0
double roundHalvable(double least);

/// Round values at equal steps within [low, high].
struct Ticks {
    std::vector<double> values;
    int decimals = 0;  // that all of them need
};

/// At most `most` of them, at least one where the range holds a round number. \pre low < high, most ≥ 2
Ticks roundTicks(const ValueRange& range, int most);

/// The range widened to round numbers at both ends, which then lie `most` ticks apart or fewer. A range of nothing but
/// zeros becomes 0 … 1; another of one value reaches from zero.
ValueRange roundedRange(const ValueRange& range, int most);

/// The same with 0 in the middle.
ValueRange roundedSymmetric(const ValueRange& range, int most);

/// A number with its size, e.g. the area that a value stands for.
struct Weighed {
    double value = 0.0;
    double weight = 1.0;
};

/// The range that leaves out, at either end, values that stand for `share` of all weight. Zeros without any values.
ValueRange rangeWithout(std::vector<Weighed> values, double share);

/// `value` with that many decimals.
std::string numberText(double value, int decimals);

/// `value` with about three digits that count.
std::string numberText(double value);

}  // namespace keyblock
