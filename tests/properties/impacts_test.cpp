// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stones that strike a slab at several moments of a step, flat and on a corner,
// under every scheme: what the energy balance leaves over is small beside what
// the impact loses. And rock at rest, whose steps are never cut for it.
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

namespace keyblock {
namespace {

constexpr double step = 2e-3;  // [s]
constexpr int steps = 60;

/// A stone of 1 m, turned by `tilt` [°], that meets a fixed slab `phase` of a step after the tenth.
Scene strikingStone(Integration scheme, double tilt, double phase) {
    const Point velocity(2.0, -5.0);
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    const double c = std::cos(tilt * std::numbers::pi / 180.0), s = std::sin(tilt * std::numbers::pi / 180.0);
    Block stone = boxBlock("stone", {-0.5, -0.5}, {0.5, 0.5});
    for (Point& p : stone.points) p = Point(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    const double lowest = std::min_element(stone.points.begin(), stone.points.end(), [](const Point& a, const Point& b) {
                              return a.y() < b.y();
                          })->y();
    const Point lift(0.0, -lowest - velocity.y() * step * (10.0 + phase));
    for (Point& p : stone.points) p += lift;
    scene.blocks = {boxBlock("slab", {-5, -1}, {10, 0}), stone};
    Support support;
    support.blockAt = Point(0.0, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    scene.analysis.tolerance = 1e-6;
    scene.output.frames = steps;
    Stage stage;
    stage.name = "strike";
    stage.kind = StageKind::Dynamic;
    stage.duration = steps * step;
    stage.timeStep = step;
    stage.integration = scheme;
    InitialVelocity initial;
    initial.blockAt = lift;
    initial.velocity = velocity;
    stage.initialVelocities = {initial};
    scene.stages = {stage};
    return scene;
}

double lostOf(const Energy& e) { return e.friction + e.plastic + e.released + e.damped; }

double accountedOf(const Energy& e) {
    return e.kinetic + e.strain + e.contact + e.bolt + lostOf(e) - e.external;
}

using SchemeAndTilt = std::tuple<Integration, double>;

class Impacts : public testing::TestWithParam<SchemeAndTilt> {};

TEST_P(Impacts, LeaveLittleEnergyUnaccountedFor) {
    const auto [scheme, tilt] = GetParam();
    for (const double phase : {0.0, 0.2, 0.4, 0.6, 0.8}) {
        const Results results = runInMemory(strikingStone(scheme, tilt, phase));
        ASSERT_EQ(results.stages.at(0).outcome, Outcome::Duration) << results.stages[0].message;
        const Energy &first = results.frames.front().energy, &last = results.frames.back().energy;
        const double lost = lostOf(last) - lostOf(first), left = accountedOf(last) - accountedOf(first);
        // a scheme that keeps energy loses nothing but friction: what is left over is compared with what strikes
        const bool keeps = scheme == Integration::Newmark;
        if (!keeps) {
            EXPECT_GT(lost, 0.1 * first.kinetic) << phase;
            EXPECT_LE(results.stages[0].health.energyCuts, steps / 20) << phase;
        }
        EXPECT_LE(std::abs(left), keeps ? 1e-3 * first.kinetic : 1e-2 * lost) << phase;
        for (std::size_t i = 1; i < results.frames.size(); ++i) {
            const Energy &before = results.frames[i - 1].energy, &after = results.frames[i].energy;
            EXPECT_LE(std::abs(accountedOf(after) - accountedOf(before)),
                      std::max(1e-2 * (lostOf(after) - lostOf(before)), (keeps ? 1e-3 : 2e-5) * first.kinetic))
                << "phase " << phase << " at " << results.frames[i].time;
        }
    }
}

TEST(Rest, NeedsNoEnergyCuts) {
    const Results results = runInMemory(brickWall({.columns = 6, .rows = 6, .duration = 0.2}));
    EXPECT_EQ(results.stages.at(0).outcome, Outcome::Duration);
    EXPECT_EQ(results.stages.at(0).health.energyCuts, 0);
}

std::string nameOfImpact(const testing::TestParamInfo<SchemeAndTilt>& info) {
    const char* names[] = {"Shi", "BackwardEuler", "Newmark", "GeneralizedAlpha"};
    return std::string(names[static_cast<int>(std::get<0>(info.param))]) + "TurnedBy" +
           std::to_string(static_cast<int>(std::get<1>(info.param)));
}

INSTANTIATE_TEST_SUITE_P(Schemes, Impacts,
                         testing::Combine(testing::Values(Integration::Shi, Integration::BackwardEuler,
                                                          Integration::Newmark, Integration::GeneralizedAlpha),
                                          testing::Values(0.0, 20.0, 60.0)),
                         nameOfImpact);

}  // namespace
}  // namespace keyblock
