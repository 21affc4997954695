// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every scheme at every step, on a fall of a kilometre and a knock at 100 m/s:
// finite numbers, no energy from nowhere, and nothing passes through the floor.
#include "solver/run/run.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace keyblock {
namespace {

using SchemeAndStep = std::tuple<Integration, double>;

class EveryScheme : public testing::TestWithParam<SchemeAndStep> {
protected:
    Integration scheme() const { return std::get<0>(GetParam()); }
    double timeStep() const { return std::get<1>(GetParam()); }
    std::vector<double> rhos() const {
        if (scheme() != Integration::GeneralizedAlpha) return {0.8};
        return {0.5, 0.8, 0.9, 1.0};
    }

    /// A stone of 1 m thrown down at `speed` from `height` above a fixed slab.
    Scene stone(double height, double speed, double duration, double rhoInf) const {
        Scene scene = emptyScene(10e9, 0.2, 30.0);
        scene.blocks = {boxBlock("slab", {-5, -1}, {10, 0}), boxBlock("stone", {0, height}, {1, height + 1})};
        Support support;
        support.blockAt = Point(0.0, -0.5);
        scene.supports = {support};
        scene.analysis.gravity = {0.0, -gravity};
        scene.analysis.tolerance = 1e-6;
        scene.analysis.rhoInf = rhoInf;
        scene.output.frames = 100;
        Stage stage;
        stage.name = "fall";
        stage.kind = StageKind::Dynamic;
        stage.duration = duration;
        stage.timeStep = timeStep();
        stage.integration = scheme();
        InitialVelocity initial;
        initial.blockAt = {0.5, height + 0.5};
        initial.velocity = {0.0, -speed};
        stage.initialVelocities = {initial};
        scene.stages = {stage};
        return scene;
    }
};

void expectSane(const Results& results, double speed) {
    ASSERT_EQ(results.stages.size(), 1u);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Duration) << results.stages[0].message;
    const double given = 0.5 * 2700.0 * speed * speed;
    for (const Frame& frame : results.frames) {
        const BlockState& block = frame.blocks[1];
        EXPECT_TRUE(block.centroid.allFinite() && block.velocity.allFinite());
        for (const double s : block.stress) EXPECT_TRUE(std::isfinite(s));
        const Energy& e = frame.energy;
        const double now = e.kinetic + e.strain + e.contact;
        EXPECT_LE(now, (given + e.external) * (1.0 + 1e-3) + 1e-9) << frame.time;
        EXPECT_GE(e.friction + e.damped, -1e-3 * (given + e.external) - 1e-9) << frame.time;
        EXPECT_LT(std::abs(e.balanceError), 1e-2) << frame.time;
        EXPECT_GT(block.centroid.y(), 0.0) << frame.time;
    }
}

TEST_P(EveryScheme, FallsAKilometre) {
    // a short step cannot wait for 14 s of fall: it gets the last of it
    const bool whole = timeStep() >= 1e-2;
    const double landing = std::sqrt(2.0 * gravity * 1000.0);
    const double speed = whole ? 0.0 : landing, height = whole ? 1000.0 : 20.0 * landing * timeStep();
    for (const double rho : rhos())
        expectSane(runInMemory(stone(height, speed, whole ? 20.0 : 200.0 * timeStep(), rho)), speed);
}

/// At most 25 s: a scheme that keeps energy lets the stone bounce 500 m high for ever, and each knock makes its spin
/// some thousand times larger. Under Newmark at steps of 1 s it is 1e-11 rad/s after the second knock and 0.3 rad/s
/// after the fifth; the sixth, at 107 s, finds the stone turned by 7 rad, at x = −3.9. It is still over the slab
/// (−5 … 10), so it does not roll off: a corner strikes at 99 m/s, and one step, linear in the rotation, turns the
/// stone by 87 rad. What follows from that means nothing, and the balance says so (−1).
TEST_P(EveryScheme, KnocksAtAHundredMetresASecond) {
    const double height = std::min(0.5, 1000.0 * timeStep());
    for (const double rho : rhos())
        expectSane(runInMemory(stone(height, 100.0, std::min(200.0 * timeStep(), 25.0), rho)), 100.0);
}

std::string nameOf(const testing::TestParamInfo<SchemeAndStep>& info) {
    const char* names[] = {"Shi", "BackwardEuler", "Newmark", "GeneralizedAlpha"};
    const long digits = -std::lround(std::log10(std::get<1>(info.param)));
    return std::string(names[static_cast<int>(std::get<0>(info.param))]) + "StepOf1em" + std::to_string(digits);
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme,
                         testing::Combine(testing::Values(Integration::Shi, Integration::BackwardEuler,
                                                          Integration::Newmark, Integration::GeneralizedAlpha),
                                          testing::Values(1e-7, 1e-5, 1e-3, 1e-2, 1e-1, 1.0)),
                         nameOf);

}  // namespace
}  // namespace keyblock
