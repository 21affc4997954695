// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The polar method decides by sums and products alone whether a number is kept or drawn again. The logarithm is
// evaluated afterwards, so that the last digit of another maths library cannot put a stream out of step.
#include "geometry/random.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr std::uint64_t goldenStep = 0x9E3779B97F4A7C15u;

std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// Probability that a standard normal variable is below `z`.
double normalShare(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

/// With s² = ln(1 + (deviation/mean)²), the mean of exp(s·z) over |z| <= c is
/// exp(s²/2)·(Φ(c − s) − Φ(−c − s)) / (Φ(c) − Φ(−c)). Draws are divided by this value.
struct LogNormal {
    double s = 0.0;
    double median = 0.0;  // [m]
};

LogNormal logNormal(const Scatter& scatter) {
    const double ratio = scatter.deviation / scatter.mean;
    const double variance = std::log1p(ratio * ratio);
    const double s = std::sqrt(variance);
    const double kept = (normalShare(scatterCut - s) - normalShare(-scatterCut - s)) /
                        (normalShare(scatterCut) - normalShare(-scatterCut));
    return {s, scatter.mean / (std::exp(0.5 * variance) * kept)};
}

}  // namespace

Random::Random(std::uint64_t seed, std::initializer_list<std::int64_t> name) : counter_(mixed(seed + goldenStep)) {
    for (const std::int64_t part : name)
        counter_ = mixed((counter_ ^ mixed(static_cast<std::uint64_t>(part) + goldenStep)) + goldenStep);
}

std::uint64_t Random::bits() {
    counter_ += goldenStep;
    return mixed(counter_);
}

double Random::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

double Random::normal() {
    for (;;) {
        const double x = 2.0 * uniform() - 1.0;
        const double y = 2.0 * uniform() - 1.0;
        const double square = x * x + y * y;
        if (square > 0.0 && square < 1.0) return x * std::sqrt(-2.0 * std::log(square) / square);
    }
}

double Random::normalWithin(double cut) {
    double z = normal();
    while (std::abs(z) > cut) z = normal();
    return z;
}

double draw(Random& random, const Scatter& scatter) {
    assert(scatter.deviation >= 0.0 && (scatter.mean > 0.0 || scatter.deviation == 0.0));
    if (scatter.deviation == 0.0) return scatter.mean;
    const LogNormal law = logNormal(scatter);
    return law.median * std::exp(law.s * random.normalWithin(scatterCut));
}

double largest(const Scatter& scatter) {
    if (scatter.deviation == 0.0 || scatter.mean == 0.0) return scatter.mean;
    const LogNormal law = logNormal(scatter);
    return law.median * std::exp(law.s * scatterCut);
}

}  // namespace keyblock
