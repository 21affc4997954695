// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Regular, slow, hasty and oscillating series of values whose limit is known.
#include "solver/trade/convergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace keyblock {
namespace {

using ConvergenceKind = ConvergenceOrder::Kind;
constexpr double convergedValue = 10.0;

/// Values of `errorAt(size)` around the limit.
std::vector<SizedValue> valuesAround(const std::vector<double>& sizes, const std::function<double(double)>& errorAt) {
    std::vector<SizedValue> values;
    for (const double size : sizes) values.push_back({size, convergedValue + errorAt(size)});
    return values;
}

TEST(Convergence, IsRegularWithTheOrderOfThePower) {
    for (const double order : {0.6, 1.0, 1.5, 2.0, 3.5}) {
        for (const double sign : {1.0, -1.0}) {
            const auto values = valuesAround({1, 2, 4}, [&](double h) { return sign * 0.01 * std::pow(h, order); });
            const ConvergenceOrder found = convergenceOf(values, {1.0, 2.0});
            ASSERT_EQ(found.kind, ConvergenceKind::Regular) << order;
            EXPECT_NEAR(found.order, order, 1e-9);
            EXPECT_NEAR(found.limit, convergedValue, 1e-9);
            EXPECT_EQ(found.scatter, 0.0);
        }
    }
}

/// As 200, 80 and 20 increments.
TEST(Convergence, IsRegularOnUnevenSizes) {
    const auto values = valuesAround({0.005, 0.0125, 0.05}, [](double h) { return 3.0 * h; });
    const ConvergenceOrder found = convergenceOf(values, {1.0, 2.0});
    ASSERT_EQ(found.kind, ConvergenceKind::Regular);
    EXPECT_NEAR(found.order, 1.0, 1e-9);
    EXPECT_NEAR(found.limit, convergedValue, 1e-9);
}

TEST(Convergence, IsIrregularOutsideTheOrdersOfTheory) {
    const auto of = [](double order) {
        return valuesAround({1, 2, 4}, [=](double h) { return 0.01 * std::pow(h, order); });
    };
    EXPECT_EQ(convergenceOf(of(0.39), {1.0, 2.0}).kind, ConvergenceKind::Irregular);
    EXPECT_EQ(convergenceOf(of(-0.5), {1.0, 2.0}).kind, ConvergenceKind::Irregular);
    EXPECT_EQ(convergenceOf(of(4.5), {1.0, 2.0}).kind, ConvergenceKind::Irregular);
    EXPECT_EQ(convergenceOf(of(2.5), {1.0, 1.0}).kind, ConvergenceKind::Irregular);
    EXPECT_EQ(convergenceOf(of(2.5), {1.0, 2.0}).kind, ConvergenceKind::Regular);
}

/// Largest shear force of a bolt pulled at 20°, for 8, 4, 2 and 1 times its divisions [kN].
TEST(Convergence, OfAForceThatGoesUpAndDownIsBoundedByItsRange) {
    const std::vector<SizedValue> values{{0.125, 46.18}, {0.25, 46.37}, {0.5, 45.16}, {1.0, 46.22}};
    const ConvergenceOrder found = convergenceOf(values, {1.0, 2.0});
    ASSERT_EQ(found.kind, ConvergenceKind::Irregular);
    EXPECT_NEAR(found.scatter, 46.37 - 45.16, 1e-12);
    EXPECT_EQ(convergenceOf(std::span(values).subspan(1), {1.0, 2.0}).kind, ConvergenceKind::Irregular);
}

/// Three values that shrink by chance after one that went the other way.
TEST(Convergence, IsIrregularWhereTheNextCoarserValueGoesTheOtherWay) {
    std::vector<SizedValue> values = valuesAround({1, 2, 4, 8}, [](double h) { return 0.01 * h; });
    EXPECT_EQ(convergenceOf(values, {1.0, 2.0}).kind, ConvergenceKind::Regular);
    values.back().value = convergedValue;
    EXPECT_EQ(convergenceOf(values, {1.0, 2.0}).kind, ConvergenceKind::Irregular);
}

/// The scatter of the three finest values contains the error of the finest one, whatever its phase.
TEST(Convergence, BoundsTheErrorOfOscillations) {
    for (double phase = 0.0; phase < 6.3; phase += 0.1) {
        const auto errorAt = [=](double h) { return 0.1 * std::sqrt(h) * std::sin(2.0 * std::log2(h) + phase); };
        const auto values = valuesAround({1, 2, 4}, errorAt);
        const ConvergenceOrder found = convergenceOf(values, {1.0, 2.0});
        if (found.kind == ConvergenceKind::Regular) continue;
        EXPECT_GE(found.scatter, std::abs(errorAt(1.0))) << phase;
    }
}

TEST(Convergence, DoesNotTrustASeriesThatIsTooFast) {
    const std::vector<SizedValue> crest{{1.0, 10.064}, {2.0, 10.060}, {4.0, 9.8}};
    const ConvergenceOrder found = convergenceOf(crest, {1.0, 2.0});
    ASSERT_EQ(found.kind, ConvergenceKind::Irregular);
    EXPECT_NEAR(found.scatter, 0.264, 1e-9);
}

TEST(Convergence, NeedsThreeValuesThatDiffer) {
    const auto values = valuesAround({1, 2, 4}, [](double) { return 0.0; });
    EXPECT_EQ(convergenceOf(values, {1.0, 2.0}).kind, ConvergenceKind::NoEffect);
    EXPECT_EQ(convergenceOf(std::span(values).first(2), {1.0, 2.0}).kind, ConvergenceKind::Unknown);
}

}  // namespace
}  // namespace keyblock
