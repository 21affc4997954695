// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pushes of a scene: a move of all coordinates changes no answer, and a settlement on
// contact springs follows the penalty ratio as its closed form says.
#include "solver/run/run.h"
#include "solver/scene/check.h"
#include "solver/trade/stress.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

Scene pushedBox() {
    Scene scene = test::boxOnBase(0.0, 30.0);
    scene.stages = {test::settle()};
    Monitor bottom;
    bottom.name = "bottom";
    bottom.point = Point(0.5, 1e-6);
    scene.monitors = {bottom};
    scene.quantities = {"stands", "min bottom.uy"};
    return scene;
}

StressSettings inMemory() {
    StressSettings settings;
    settings.run = [](const Scene& scene, const SceneCut& cut, const std::string&, Sink& sink) {
        Control control;
        run(scene, sink, control, {1, &cut});
    };
    return settings;
}

const StressPoint& pointAt(const StressTest& stress, const std::string& axis, const std::string& text) {
    return *std::find_if(stress.points.begin(), stress.points.end(),
                         [&](const StressPoint& point) { return point.push.axis == axis && point.push.text == text; });
}

TEST(StressTest, SettlementFollowsThePenaltyRatio) {
    StressTest stress;
    ASSERT_TRUE(measureStress(pushedBox(), inMemory(), stress));
    EXPECT_EQ(pointAt(stress, "coordinates", "+ 1e+06 m").ending, StressEnding::Same);
    EXPECT_EQ(pointAt(stress, "tolerance", "÷ 100").ending, StressEnding::Same);
    const StressPoint& soft = pointAt(stress, "penalty ratio", "÷ 10");
    EXPECT_EQ(soft.ending, StressEnding::Moved);
    EXPECT_NEAR(soft.moved, 9.0, 0.1);  // W/2k, ten times as much
    ASSERT_GE(firstToBreak(stress), 0);
    EXPECT_EQ(stress.points[firstToBreak(stress)].push.axis, "penalty ratio");
    EXPECT_NE(stressAnswer(stress).find("normal_stiffness"), std::string::npos);
}

TEST(StressTest, StopsWithARun) {
    StressSettings settings;
    settings.run = [](const Scene& scene, const SceneCut& cut, const std::string& label, Sink& sink) {
        Control control;
        control.stop = !label.starts_with("run 1 ") && !label.starts_with("run 2 ");
        run(scene, sink, control, {1, &cut});
    };
    StressTest stress;
    EXPECT_FALSE(measureStress(pushedBox(), settings, stress));
    EXPECT_TRUE(stress.interrupted);
    EXPECT_EQ(stress.points.size(), 1u);
}

}  // namespace
}  // namespace keyblock
