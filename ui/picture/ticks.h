// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round numbers for axes, legends and scale bars, and the text of displayed numbers: a
// true minus sign, thin spaces between thousands, and as many decimals as the tick
// interval requires.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct ValueRange {
    double low = 0.0, high = 0.0;

    bool operator==(const ValueRange&) const = default;
};

/// True if a value can be drawn: it is a finite number of at most 1e100, so that squares and differences are finite too.
/// Every range that comes from results is made of such values, because the results of a failed stage, or of a damaged
/// run file, may have others.
bool canBeShown(double value);

/// The smallest number not below `least` that is 1, 2, 2.5 or 5 times a power of ten; 1 if `least` is below 1e-100 or
/// cannot be shown.
double roundStep(double least);

/// The smallest number not below `least` that is 1, 2 or 5 times a power of ten, so that half of it is also a round
/// number; 1 if `least` is below 1e-100 or cannot be shown.
double roundHalvable(double least);

/// Round values at equal intervals within a range.
struct Ticks {
    std::vector<double> values;
    int decimals = 0;  // decimals that all values need
};

/// At most `most` ticks within the range; none if an end cannot be shown or the range is not wider than 1e-100.
/// \pre most ≥ 2
Ticks roundTicks(const ValueRange& range, int most);

/// The range, extended at both ends to multiples of a round tick interval. The interval is chosen so that the result
/// has at most `most` ticks. The range 0 … 0, or one with an end that cannot be shown, becomes 0 … 1; any other range of
/// zero width is first extended to include zero.
ValueRange roundedRange(const ValueRange& range, int most);

/// Like `roundedRange`, but the result is symmetric about zero.
ValueRange roundedSymmetric(const ValueRange& range, int most);

/// A value with its weight, such as the area of the block to which it belongs.
struct Weighed {
    double value = 0.0;
    double weight = 1.0;
};

/// Range of the values without the extremes: at each end, values whose weights add up to at most the fraction `share`
/// of the total weight are left out. Values that cannot be shown are left out too. The range is 0 … 0 if there are no
/// values.
ValueRange rangeWithout(std::vector<Weighed> values, double share);

/// Text of `value` with the given number of decimals.
std::string numberText(double value, int decimals);

/// Text of `value` with about three significant digits.
std::string numberText(double value);

}  // namespace keyblock
