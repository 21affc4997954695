// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Statistics of samples: quantiles, the interval of a probability, rank correlation.
#pragma once

#include <span>
#include <vector>

namespace keyblock {

struct SampleStatistics {
    std::size_t count = 0;
    double mean = 0.0;
    double deviation = 0.0;  // with count − 1; 0 for one value
    double least = 0.0, most = 0.0;
};

/// Statistics of a sample; all 0 if it is empty.
SampleStatistics statisticsOf(std::span<const double> values);

/// Quantile with linear interpolation between the order statistics (Hyndman and Fan 1996, type 7).
/// \param sorted in ascending order, not empty. \pre 0 ≤ share ≤ 1
double quantileOf(std::span<const double> sorted, double share);

struct ChanceInterval {
    double low = 0.0, high = 1.0;
};

/// 95 % interval of a probability after `hits` in `trials` (Wilson 1927); 0 to 1 without trials.
ChanceInterval wilsonInterval(long hits, long trials);

/// Spearman's rank correlation, with the mean rank of equal values. 0 for fewer than three pairs, or if one of the two
/// is constant. Both have the same length.
double rankCorrelation(std::span<const double> x, std::span<const double> y);

}  // namespace keyblock
