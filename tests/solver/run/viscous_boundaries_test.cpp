// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides that let waves out.
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/activation.h"
#include "solver/run/run.h"

#include "solver/engine/boundary.h"
#include "solver/scene/scene_cut.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double barLength = 20.0, cell = 0.25, speed = 1000.0, barDensity = 2700.0;

/// A bar of cells in which pressure waves run at 1000 m/s; with ν = 0 nothing goes aside.
Scene bar() {
    Scene scene = emptyScene(barDensity * speed * speed, 0.0, 30.0);
    scene.materials[0].second.density = barDensity;
    scene.blocks = {boxBlock("bar", {0, 0}, {barLength, cell})};
    scene.blocks[0].subBlocks = CellSettings{cell};
    Monitor middle;
    middle.name = "middle";
    middle.point = Point(0.5 * barLength + 0.1, 0.1);
    scene.monitors = {middle};
    return scene;
}

/// A push on the left end of 5 ms, half a sine.
Load push(const Point& force) {
    Load load;
    load.point = Point(0.0, 0.5 * cell);
    load.force = force;
    for (int i = 0; i <= 20; ++i)
        load.table.emplace_back(5e-3 * i / 20.0, std::sin(std::numbers::pi * i / 20.0));
    load.table.back().second = 0.0;
    return load;
}

/// Largest speed of the cell in the middle before and after a time.
std::pair<double, double> speedsBeforeAndAfter(const Solved& solved, double time) {
    double before = 0.0, after = 0.0;
    for (const Frame& frame : solved.results.frames) {
        const double v = frame.blocks[frame.blocks.size() / 2].velocity.norm();
        (frame.time < time ? before : after) = std::max(frame.time < time ? before : after, v);
    }
    return {before, after};
}

double reflected(const std::vector<std::string>& sides, Integration integration) {
    Scene scene = bar();
    // the loss of Shi's scheme over the way grows with the step
    Stage stage = test::dynamic(0.045, integration == Integration::Shi ? 2e-5 : 1e-4);
    stage.integration = integration;
    stage.loads = {push({1e5, 0.0})};
    stage.viscousBoundaries = sides;
    scene.stages = {stage};
    scene.output.frames = 450;
    const Solved solved = solve(scene);
    EXPECT_EQ(solved.results.stages[0].outcome, Outcome::Duration);
    EXPECT_LT(std::abs(solved.results.stages[0].health.balanceError), 1e-3);
    const auto [there, back] = speedsBeforeAndAfter(solved, 0.022);
    EXPECT_NEAR(there, 1e5 / (barDensity * speed * cell), 0.03 * there);  // force over impedance
    return back / there;
}

TEST(ViscousBoundaries, AWaveLeavesTheBar) {
    EXPECT_LT(reflected({"right"}, Integration::Newmark), 0.02);
    EXPECT_LT(reflected({"right"}, Integration::Shi), 0.02);
    EXPECT_GT(reflected({}, Integration::Newmark), 0.9);
}

/// Reaction of what held the side stays: a bar under pressure between its load and that side does not move.
TEST(ViscousBoundaries, TheReactionOfTheStaticStateStays) {
    Scene scene = bar();
    for (double y : {0.0, cell}) {
        Support support;
        support.point = Point(barLength, y);
        support.fix = Fix::XY;
        scene.supports.push_back(support);
    }
    Stage loaded = test::settle(), quiet = test::dynamic(0.02, 1e-4), rest = test::settle();
    Load pressure;
    pressure.along = std::array<Point, 2>{Point(0.0, 0.0), Point(0.0, cell)};
    pressure.pressure = 1e6;
    loaded.loads = {pressure};
    quiet.viscousBoundaries = {"right"};
    rest.name = "rest";
    scene.stages = {loaded, quiet, rest};
    const Solved solved = solve(scene);
    const auto lastOf = [&](int stage) {
        return *std::find_if(solved.results.frames.rbegin(), solved.results.frames.rend(),
                             [&](const Frame& frame) { return frame.stage == stage; });
    };
    const double shortened = 1e6 * barLength / (barDensity * speed * speed);
    for (int stage : {1, 2}) {
        EXPECT_LT((lastOf(stage).blocks[0].centroid - lastOf(0).blocks[0].centroid).norm(), 1e-6 * shortened) << stage;
        EXPECT_LT(std::abs(solved.results.stages[stage].health.balanceError), 1e-6);
    }
    EXPECT_LT(lastOf(1).blocks[0].velocity.norm(), 1e-6);
}

/// Impedance over the faces of a side of a domain whose right side slants; only what holds that side lets go.
TEST(ViscousBoundaries, StandOnTheSideOfTheDomain) {
    Scene scene = bar();
    scene.blocks.clear();
    scene.domain = SceneDomain{{{0, 0}, {4, 0}, {3, 2}, {0, 2}}, scene.materials.front().first, {}};
    SceneJoint level;
    level.name = "level";
    level.points = {{0.0, 1.0}, {4.0, 1.0}};
    scene.joints = {level};
    for (BoundarySide side : {BoundarySide::Left, BoundarySide::Right}) {
        Support support;
        support.boundary = side;
        support.fix = Fix::X;
        scene.supports.push_back(support);
    }
    Stage stage = test::dynamic(0.01, 1e-4);
    stage.viscousBoundaries = {"right"};
    scene.stages = {stage};
    const Model model = makeModel(cutScene(scene).scene);
    State state = makeState(model);
    const std::vector<Dashpot> dashpots = dashpotsOn(model, state, {BoundarySide::Right});
    ASSERT_EQ(dashpots.size(), 4u);  // two a face of either block
    double pressure = 0.0, shear = 0.0;
    for (const Dashpot& dashpot : dashpots) {
        pressure += dashpot.pressure, shear += dashpot.shear;
        EXPECT_LT((dashpot.across - Point(2.0, 1.0).normalized()).norm(), 1e-12);
    }
    const double all = barDensity * speed * std::sqrt(5.0) * scene.analysis.thickness;
    EXPECT_NEAR(pressure, all, 1e-9 * all);
    EXPECT_NEAR(shear, all / std::sqrt(2.0), 1e-9 * all);  // ν = 0: c_p/c_s = √2
    EXPECT_EQ(releaseSupports(model, state, {BoundarySide::Right}).size(), 4u);
    EXPECT_EQ(releaseSupports(model, state, {BoundarySide::All}).size(), 8u);
    EXPECT_EQ(dashpotsOn(model, state, {BoundarySide::Left, BoundarySide::Right}).size(), 8u);
}

}  // namespace
}  // namespace keyblock
