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
    int decimals = 0;  // needed by all of them
};

/// At most `most` of them, at least one if the range contains a round number. \pre low < high, most ≥ 2
Ticks roundTicks(const ValueRange& range, int most);

/// The range extended to round numbers at both ends, which are then at most `most` ticks apart. A range with only
/// zeros becomes 0 … 1; another of one value starts at zero.
ValueRange roundedRange(const ValueRange& range, int most);

/// The same with 0 in the middle.
ValueRange roundedSymmetric(const ValueRange& range, int most);

/// A number with its weight, e.g. the area of its block.
struct Weighed {
    double value = 0.0;
    double weight = 1.0;
};

/// The range that excludes, at either end, values with `share` of the total weight. Zeros without any values.
ValueRange rangeWithout(std::vector<Weighed> values, double share);

/// `value` with that many decimals.
std::string numberText(double value, int decimals);

/// `value` with about three significant digits.
std::string numberText(double value);

}  // namespace keyblock
