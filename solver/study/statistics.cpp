// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace keyblock {

namespace {

double meanOf(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Ranks from 1; equal values get the mean of theirs.
std::vector<double> ranksOf(std::span<const double> values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    std::vector<double> ranks(values.size());
    for (std::size_t from = 0; from < order.size();) {
        std::size_t to = from;
        while (to < order.size() && values[order[to]] == values[order[from]]) ++to;
        for (std::size_t i = from; i < to; ++i) ranks[order[i]] = 0.5 * static_cast<double>(from + to + 1);
        from = to;
    }
    return ranks;
}

}  // namespace

SampleStatistics statisticsOf(std::span<const double> values) {
    SampleStatistics result;
    result.count = values.size();
    if (values.empty()) return result;
    result.mean = meanOf(values);
    double sum = 0.0;
    for (const double value : values) sum += (value - result.mean) * (value - result.mean);
    if (values.size() > 1) result.deviation = std::sqrt(sum / static_cast<double>(values.size() - 1));
    const auto [least, most] = std::ranges::minmax(values);
    result.least = least;
    result.most = most;
    return result;
}

double quantileOf(std::span<const double> sorted, double share) {
    assert(!sorted.empty());
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

ChanceInterval wilsonInterval(long hits, long trials) {
    if (trials == 0) return {};
    constexpr double z = 1.959963984540054;  // 97.5 % quantile of the standard normal distribution
    const double n = static_cast<double>(trials), p = static_cast<double>(hits) / n, share = z * z / n;
    const double centre = (p + 0.5 * share) / (1.0 + share);
    const double half = z * std::sqrt(p * (1.0 - p) / n + 0.25 * share / n) / (1.0 + share);
    return {hits == 0 ? 0.0 : centre - half, hits == trials ? 1.0 : centre + half};
}

double rankCorrelation(std::span<const double> x, std::span<const double> y) {
    assert(x.size() == y.size());
    if (x.size() < 3) return 0.0;
    const std::vector<double> a = ranksOf(x), b = ranksOf(y);
    const double mean = 0.5 * static_cast<double>(x.size() + 1);
    double aa = 0.0, bb = 0.0, ab = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - mean) * (a[i] - mean);
        bb += (b[i] - mean) * (b[i] - mean);
        ab += (a[i] - mean) * (b[i] - mean);
    }
    return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}  // namespace keyblock
