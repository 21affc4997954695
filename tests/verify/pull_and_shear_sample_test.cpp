// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sample of pull and shear with automatic and with twice as many elements. As the
// pull on the bolt approaches its yield force, the moment that hinges can carry vanishes,
// and half the elements between the first hinges become hinges one after the other.
#include "solver/run/run.h"
#include "solver/verify/readings.h"
#include "tests/verify/sample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double pulledBy = 5.1e-3;  // [m], at which the bolt has yielded
constexpr double barYields = 490e6 * 314.16e-6;  // [N] of the bar, 20 mm

/// The beginning of the sample with the settings of the preset and `factor` times as many elements.
Scene beginningOfThePull(double factor) {
    Scene scene = test::sample("angle-dbolt-40");
    scene.about.expected.clear();
    scene.analysis.maxPasses.reset();
    scene.analysis.divisionsFactor = factor;
    scene.stages[0].increments.reset();
    scene.stages[0].motions[0].table = {{0.0, 0.0}, {pulledBy / 0.15, pulledBy}, {1.0, pulledBy}};
    return scene;
}

TEST(PullAndShear, HingesInFineElementsNeedNoShorterIncrements) {
    const Solved coarse = solve(beginningOfThePull(1.0)), fine = solve(beginningOfThePull(2.0));
    for (const Solved* each : {&coarse, &fine}) {
        const StageResult& stage = each->results.stages.at(0);
        ASSERT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
        EXPECT_EQ(stage.health.stepCuts, 0);
        EXPECT_LT(stage.health.maxResidual, 1e-3);  // round-off before the pull begins is no share of it
        EXPECT_LT(std::abs(each->results.frames.back().energy.balanceError), 1e-3);
        EXPECT_GT(reading(*each, "max axial"), barYields);
    }
    EXPECT_GT(countOf(fine, EventKind::Hinge), 1.5 * countOf(coarse, EventKind::Hinge));
    EXPECT_NEAR(reading(fine, "max axial"), reading(coarse, "max axial"), 2e-3 * barYields);
}

}  // namespace
}  // namespace keyblock
