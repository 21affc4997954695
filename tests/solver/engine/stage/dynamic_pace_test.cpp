// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The length of time steps, with attempts that fail wherever a step is longer than the
// rock allows at that time.
#include "solver/engine/stage/dynamic_pace.h"

#include <gtest/gtest.h>

#include <functional>

namespace keyblock {
namespace {

constexpr double longest = 1e-3;  // s

struct Counts {
    int steps = 0, cuts = 0;
    double last = 0.0;  // length of the last step [s]
};

/// \param allowed the longest step that converges at a time [s].
Counts stepsTo(double end, const std::function<double(double time)>& allowed) {
    DynamicPace pace;
    pace.dt = longest;
    Counts counts;
    for (double time = 0.0; time < end; time += counts.last) {
        double dt = pace.dt;
        while (dt > allowed(time)) {
            dt = cutStep(pace, dt);
            ++counts.cuts;
        }
        ++counts.steps;
        counts.last = dt;
        lengthenStep(pace, dt, longest);
    }
    return counts;
}

TEST(DynamicPace, AStepThatConvergesIsNeverShortened) {
    const Counts counts = stepsTo(0.1, [](double) { return longest; });
    EXPECT_EQ(counts.cuts, 0);
    EXPECT_DOUBLE_EQ(counts.last, longest);
}

TEST(DynamicPace, AfterASingleCutTheStepDoublesAtOnce) {
    DynamicPace pace;
    const double cut = cutStep(pace, longest);
    EXPECT_LT(cut, longest);
    lengthenStep(pace, cut, longest);
    EXPECT_DOUBLE_EQ(pace.dt, 2.0 * cut);
}

TEST(DynamicPace, AfterALongerStepThatFailsTheLastLengthIsTriedAgain) {
    DynamicPace pace;
    const double cut = cutStep(pace, longest);
    lengthenStep(pace, cut, longest);
    EXPECT_DOUBLE_EQ(cutStep(pace, pace.dt), cut);
    EXPECT_LT(cutStep(pace, cut), cut);
}

TEST(DynamicPace, WedgedRockCutsLessThanTwoStepsInAHundred) {
    const Counts counts = stepsTo(1.0, [](double) { return 0.5 * longest; });
    EXPECT_GT(counts.cuts, 0);
    EXPECT_LT(counts.cuts, 0.02 * counts.steps);
}

TEST(DynamicPace, StepsHaveTheirLengthAgainSoonAfterTheRockIsFree) {
    const Counts counts = stepsTo(0.6, [](double time) { return time < 0.5 ? 0.5 * longest : longest; });
    EXPECT_DOUBLE_EQ(counts.last, longest);
}

TEST(DynamicPace, SingleCutsFarApartDoNotAddUp) {
    const Counts counts = stepsTo(1.0,
                                  [](double time) { return int(1e3 * time) % 100 == 50 ? 0.5 * longest : longest; });
    EXPECT_LE(counts.steps, 1100);
}

}  // namespace
}  // namespace keyblock
