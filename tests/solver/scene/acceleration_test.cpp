// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accelerations against what can be worked out by hand.
#include "solver/scene/acceleration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double pi = std::numbers::pi;

const Table ramp{{0.5, 1.0}, {1.0, 3.0}, {2.0, -1.0}};

TEST(Record, RunsStraightBetweenItsRowsAndIsNothingOutside) {
    EXPECT_EQ(recordAt(ramp, 0.0), 0.0);
    EXPECT_EQ(recordAt(ramp, 0.5), 1.0);
    EXPECT_EQ(recordAt(ramp, 0.75), 2.0);
    EXPECT_EQ(recordAt(ramp, 1.0), 3.0);
    EXPECT_EQ(recordAt(ramp, 1.25), 2.0);
    EXPECT_EQ(recordAt(ramp, 2.0), -1.0);
    EXPECT_EQ(recordAt(ramp, std::nextafter(2.0, 3.0)), 0.0);
    EXPECT_EQ(recordAt({}, 1.0), 0.0);
}

TEST(Acceleration, ActsAlongItsAxis) {
    Acceleration a;
    a.sine = Sine{2.0, 0.25, pi / 2};
    a.axis = {3.0, 4.0};
    a.factor = 10.0;
    EXPECT_NEAR(accelerationAt(a, 0.0).x(), 12.0, 1e-12);
    EXPECT_NEAR(accelerationAt(a, 0.0).y(), 16.0, 1e-12);
    EXPECT_NEAR(accelerationAt(a, 1.0).norm(), 0.0, 1e-12);
    EXPECT_NEAR(accelerationAt(a, 2.0).x(), -12.0, 1e-12);
}

/// A ground that accelerates one way acts as a force the other way.
TEST(Acceleration, OfTheGroundIsThatOfTheBodyReversed) {
    Stage stage;
    EXPECT_EQ(bodyForceAt(stage, 1.0), Point(0.0, 0.0));
    Acceleration a;
    a.record = ramp;
    stage.baseAcceleration = a;
    EXPECT_EQ(bodyForceAt(stage, 0.75), Point(-2.0, 0.0));
    stage.bodyAcceleration = a;
    EXPECT_EQ(bodyForceAt(stage, 0.75), Point(0.0, 0.0));
}

/// v and d of the straight lines, integrated by hand: from 1 to 3 in 0.5 s, then to −1 in 1 s.
TEST(Baseline, IsTheExactIntegral) {
    const Baseline b = baselineOf(ramp, 2.0);
    const double v1 = 2.0 * (0.5 * 2.0), d1 = 2.0 * (0.25 / 6.0 * (2.0 + 3.0));
    EXPECT_NEAR(b.velocity, v1 + 2.0 * 1.0, 1e-14);
    EXPECT_NEAR(b.displacement, d1 + v1 + 2.0 / 6.0 * (6.0 - 1.0), 1e-14);
    EXPECT_EQ(b.peakVelocity, b.velocity);
}

/// A whole period of a cosine ends where it began and at rest; the straight lines between its rows miss that by what
/// the trapezium rule does on a period: nothing for the velocity, nor for the displacement of a symmetric period.
TEST(Baseline, OfAPeriodVanishes) {
    Table record;
    const int rows = 100;
    for (int i = 0; i <= rows; ++i) record.emplace_back(0.01 * i, std::cos(2.0 * pi * i / rows));
    const Baseline b = baselineOf(record, 1.0);
    EXPECT_NEAR(b.velocity, 0.0, 1e-15);
    EXPECT_NEAR(b.displacement, 0.0, 1e-15);
    EXPECT_NEAR(b.peakVelocity, 1.0 / (2.0 * pi), 1e-3);
    EXPECT_NEAR(b.peakDisplacement, 2.0 / (4.0 * pi * pi), 1e-4);
}

TEST(Acceleration, LimitsTheStepThatFollowsIt) {
    Stage stage;
    EXPECT_TRUE(std::isinf(longestStepFor(stage)));
    stage.bodyAcceleration.emplace();
    stage.bodyAcceleration->sine = Sine{1.0, 5.0, 0.0};
    EXPECT_DOUBLE_EQ(longestStepFor(stage), 0.005);
    stage.baseAcceleration.emplace();
    stage.baseAcceleration->record = {{0.0, 0.0}, {0.002, 1.0}, {0.004, 0.0}};
    EXPECT_DOUBLE_EQ(longestStepFor(stage), 0.002);
}

}  // namespace
}  // namespace keyblock
