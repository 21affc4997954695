// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantiles are checked against the distribution functions, which are calculated in
// another way, and moments against their closed forms.
#include "solver/study/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace keyblock {
namespace {

StudyDistribution normalOf(double mean, double deviation) {
    StudyDistribution d;
    d.kind = DistributionKind::Normal;
    d.mean = mean;
    d.deviation = deviation;
    return d;
}

StudyDistribution triangular(double least, double peak, double most) {
    StudyDistribution d;
    d.kind = DistributionKind::Triangular;
    d.least = least;
    d.peak = peak;
    d.most = most;
    return d;
}

/// Mean of a function of the variable, by the midpoint rule over probabilities.
double meanOf(const StudyDistribution& d, const std::function<double(double)>& function) {
    constexpr int parts = 200000;
    double sum = 0.0;
    for (int i = 0; i < parts; ++i) sum += function(quantileOf(d, (i + 0.5) / parts));
    return sum / parts;
}

TEST(StudyDistributions, NormalQuantileInvertsTheErrorFunction) {
    for (const double p : {1e-300, 1e-20, 1e-6, 0.02, 0.0749, 0.3, 0.5, 0.6, 0.925, 0.999, 1.0 - 1e-12}) {
        const double z = normalQuantile(p);
        const double slope = std::exp(-0.5 * z * z) / std::sqrt(2.0 * 3.14159265358979323846);
        EXPECT_NEAR(normalShare(z), p, 1e-14 * p + 4e-16 * slope * std::abs(z) + 1e-15 * (p > 0.5)) << p;
    }
    EXPECT_NEAR(normalQuantile(0.975), 1.959963984540054, 1e-15);
    EXPECT_EQ(normalQuantile(0.5), 0.0);
}

TEST(StudyDistributions, MeanAndDeviationAreThoseGiven) {
    StudyDistribution lognormal = normalOf(4.0, 3.0);
    lognormal.kind = DistributionKind::Lognormal;
    for (const StudyDistribution& d : {normalOf(4.0, 3.0), lognormal}) {
        const double mean = meanOf(d, [](double x) { return x; });
        EXPECT_NEAR(mean, 4.0, 2e-4);
        EXPECT_NEAR(std::sqrt(meanOf(d, [&](double x) { return (x - mean) * (x - mean); })), 3.0, 3e-3);
    }
    const double mean = meanOf(triangular(1.0, 2.0, 6.0), [](double x) { return x; });
    EXPECT_NEAR(mean, 3.0, 1e-6);
    EXPECT_NEAR(meanOf(triangular(1.0, 2.0, 6.0), [&](double x) { return (x - mean) * (x - mean); }), 21.0 / 18.0,
                1e-5);
}

TEST(StudyDistributions, TruncationKeepsTheShapeBetweenTheBounds) {
    StudyDistribution d = normalOf(30.0, 5.0);
    d.least = 28.0;
    d.most = 45.0;
    EXPECT_GE(quantileOf(d, 1e-12), 28.0);
    EXPECT_LE(quantileOf(d, 1.0 - 1e-12), 45.0);
    // the share below x is that of the whole distribution between the bounds
    const double kept = normalShare(3.0) - normalShare(-0.4);
    EXPECT_NEAR(shareBelow(d, 30.0), (0.5 - normalShare(-0.4)) / kept, 1e-14);
    for (const double u : {0.1, 0.5, 0.9}) EXPECT_NEAR(shareBelow(d, quantileOf(d, u)), u, 1e-14);
}

TEST(StudyDistributions, TriangleMayHaveItsPeakAtAnEnd) {
    EXPECT_NEAR(quantileOf(triangular(0.0, 0.0, 1.0), 0.75), 0.5, 1e-15);
    EXPECT_NEAR(quantileOf(triangular(0.0, 1.0, 1.0), 0.25), 0.5, 1e-15);
}

}  // namespace
}  // namespace keyblock
