// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a scene is made of, against counts by hand; what it leaves out; and that the
// estimate follows from what it says it does. How long runs really take is no test.
#include "solver/run/model_summary.h"

#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace keyblock {
namespace {

using test::line;

ModelSummary modelSummaryOf(const Scene& scene) {
    const SceneCut cut = cutScene(scene);
    return *makeModelSummary(cut.scene, &cut);
}

Scene sample(const std::string& name) {
    return *readSceneFile(std::string(KEYBLOCK_SAMPLES_DIR) + "/" + name + ".json").scene;
}

const LeftOut* find(const ModelSummary& summary, const std::string& what) {
    const auto found = std::find_if(summary.leftOut.begin(), summary.leftOut.end(),
                                    [&](const LeftOut& part) { return part.what == what; });
    return found == summary.leftOut.end() ? nullptr : &*found;
}

/// A block that is held and one that is pulled, with one face between them, and a bolt of 59 elements.
TEST(ModelSummary, OfTheRebarIsWhatIsCountedByHand) {
    const ModelSummary summary = modelSummaryOf(sample("rebar-stated"));
    const ModelCounts& counts = summary.counts;
    EXPECT_EQ(counts.blocks, 2);
    EXPECT_EQ(counts.fixed, 1);
    EXPECT_EQ(counts.blockUnknowns, 6);
    EXPECT_EQ(counts.bolts, 1);
    EXPECT_EQ(counts.nodes, 60);
    EXPECT_EQ(counts.realAnchors, 60);
    EXPECT_EQ(counts.boltUnknowns, 180);
    EXPECT_EQ(counts.contacts, 2);  // both ends of the face
    EXPECT_EQ(counts.unknowns(), 186);
    ASSERT_TRUE(find(summary, "prescribed displacements"));
    EXPECT_EQ(find(summary, "prescribed displacements")->saves, "2 unknowns");  // along the axis, and the rotation
    EXPECT_TRUE(find(summary, "plates"));
    EXPECT_TRUE(find(summary, "motion over time"));
    EXPECT_FALSE(find(summary, "bolts"));
}

/// 4 rows of 40 cells: between rows 3 × 40 edges are glued, between columns 4 × 39.
TEST(ModelSummary, OfTheCantileverIsWhatIsCountedByHand) {
    const ModelSummary summary = modelSummaryOf(sample("cantilever"));
    EXPECT_EQ(summary.counts.blocks, 160);
    EXPECT_EQ(summary.counts.cells, 160);
    EXPECT_EQ(summary.counts.gluedEdges, 3 * 40 + 4 * 39);
    EXPECT_EQ(summary.counts.blockUnknowns, 960);
    EXPECT_EQ(summary.counts.contacts, 0);
    EXPECT_TRUE(find(summary, "bolts"));
    EXPECT_FALSE(find(summary, "stress variation within blocks"));
}

TEST(ModelSummary, CountsAPlateThatIsABlock) {
    const ModelCounts counts = modelSummaryOf(sample("plate-block")).counts;
    EXPECT_EQ(counts.blocks, 2);
    EXPECT_EQ(counts.plates, 1);
    EXPECT_EQ(counts.plateUnknowns, 6);
    EXPECT_EQ(counts.contacts, 4);  // two under the plate, two between the blocks
    EXPECT_EQ(counts.boltUnknowns, 3 * 61);
}

/// A strip of 4 m × 1 m cut by uprights into five, the second of which is a tunnel that is open from the start.
Scene strip() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.domain = SceneDomain{{{0, 0}, {4, 0}, {4, 1}, {0, 1}}, scene.materials.front().first, {}};
    for (double x : {1.0, 2.0, 3.0, 3.5}) scene.joints.push_back(line("at " + std::to_string(x), {x, 0}, {x, 1}));
    SceneTunnel tunnel;
    tunnel.name = "opening";
    tunnel.profile = ProfileKind::Polygon;
    tunnel.points = {{1, 0}, {2, 0}, {2, 1}, {1, 1}};
    scene.tunnels = {tunnel};
    Support support;
    support.boundary = BoundarySide::Bottom;
    support.fix = Fix::XY;
    scene.supports = {support};
    scene.stages = {test::settle()};
    return scene;
}

/// Blocks from 0 to 1, 2 to 3, 3 to 3.5 and 3.5 to 4: two faces between them, each with two contacts, and four faces at
/// the bottom, each held at both ends.
TEST(ModelSummary, OfACutSceneIsWhatIsCountedByHand) {
    const ModelSummary summary = modelSummaryOf(strip());
    EXPECT_EQ(summary.counts.blocks, 4);
    EXPECT_EQ(summary.counts.blockUnknowns, 24);
    EXPECT_EQ(summary.counts.contacts, 4);
    EXPECT_EQ(summary.counts.heldPoints, 8);
    ASSERT_TRUE(find(summary, "rock in tunnels"));
    EXPECT_EQ(find(summary, "rock in tunnels")->saves, "1 block of six unknowns");
}

TEST(ModelSummary, LeavesOutNothingThatIsAskedFor) {
    Scene scene = strip();
    scene.analysis.contact = ContactMethod::AugmentedLagrangian;
    scene.analysis.gravity = {0.0, -gravity};
    scene.analysis.damping.mass = 0.1;
    scene.inSituStress = InSituStress{};
    scene.jointMaterials[0].second.cohesion = 1e5;
    Stage stage = test::dynamic(0.1, 1e-3);
    stage.viscousBoundaries = {"left"};
    stage.dilations = {{scene.joints[1].name, 1e-3}};
    scene.stages.push_back(stage);
    const ModelSummary summary = modelSummaryOf(scene);
    for (const char* what : {"forces that keep contacts closed exactly", "weight", "damping", "opening of joints",
                             "stress before excavation", "non-reflecting sides", "motion over time",
                             "searches for equilibrium", "failure of joint bonds"})
        EXPECT_FALSE(find(summary, what)) << what;
}

/// Steps are those that the run will make.
TEST(ModelSummary, EstimatesFromTheStepsOfEveryStage) {
    Scene scene = test::boxOnBase(20.0, 30.0);
    Stage loaded = test::settle();
    loaded.increments = 7;
    scene.stages = {test::settle(), loaded, test::dynamic(0.5, 1e-3)};
    const CostEstimate estimate = modelSummaryOf(scene).estimate;
    ASSERT_EQ(estimate.stages.size(), 3u);
    EXPECT_EQ(estimate.stages[0].steps, 1.0);
    EXPECT_EQ(estimate.stages[1].steps, 8.0);
    EXPECT_NEAR(estimate.stages[2].steps, 500.0, 1e-9);
    for (const StageCost& stage : estimate.stages) {
        EXPECT_LE(stage.least, stage.passes);
        EXPECT_GE(stage.most, stage.passes);
        EXPECT_GT(stage.passes, 0.0);
    }
    EXPECT_LE(estimate.secondsLeast, estimate.seconds);
    EXPECT_GE(estimate.secondsMost, estimate.seconds);
    EXPECT_GT(estimate.passSeconds, 0.0);
    EXPECT_GT(estimate.memory, 1e6);
    EXPECT_FALSE(estimate.assumes.empty());
}

TEST(ModelSummary, OfASceneWithoutStagesHasNothingToRun) {
    Scene scene = test::boxOnBase(20.0, 30.0);
    scene.stages.clear();
    EXPECT_TRUE(modelSummaryOf(scene).estimate.stages.empty());
}

/// A run of milliseconds is made to its end: its iterations are counted, not estimated.
TEST(ModelSummary, CountsTheIterationsOfAShortRun) {
    const Scene scene = sample("free-fall");
    const CostEstimate estimate = modelSummaryOf(scene).estimate;
    const Results results = runInMemory(scene);
    ASSERT_EQ(estimate.stages.size(), results.stages.size());
    for (std::size_t i = 0; i < results.stages.size(); ++i) {
        EXPECT_EQ(estimate.stages[i].passes, static_cast<double>(results.stages[i].health.passes));
        EXPECT_EQ(estimate.stages[i].least, estimate.stages[i].most);
    }
}

/// The band is at most half to double, and a run that takes longer than the measurement is estimated as longer.
TEST(ModelSummary, EstimatesATimeWithABandOfHalfToDouble) {
    Scene scene = test::boxOnBase(20.0, 30.0);
    scene.stages = {test::settle(), test::dynamic(10000.0, 1e-3)};
    const CostEstimate estimate = modelSummaryOf(scene).estimate;
    EXPECT_GT(estimate.seconds, 1.0);
    EXPECT_DOUBLE_EQ(estimate.secondsMost, 2.0 * estimate.seconds);
    EXPECT_DOUBLE_EQ(estimate.secondsLeast, 0.5 * estimate.seconds);
}

/// The measurement ends soon after the request.
TEST(ModelSummary, StopsWhenItIsNoLongerNeeded) {
    const std::atomic<bool> stop{true};
    const SceneCut cut = cutScene(sample("rebar-stated"));
    EXPECT_FALSE(makeModelSummary(cut.scene, &cut, &stop));
}

TEST(ModelSummary, NamesWhatCouldBeLeftOutNext) {
    Scene scene = sample("rebar-stated");
    const auto has = [](const ModelSummary& summary, const std::string& axis) {
        return std::any_of(summary.next.begin(), summary.next.end(),
                           [&](const NextLeftOut& next) { return next.axis == axis && !next.measured; });
    };
    ModelSummary summary = modelSummaryOf(scene);
    EXPECT_FALSE(has(summary, "divisions"));  // the bond is given per node
    EXPECT_TRUE(has(modelSummaryOf(sample("dbolt-table-steel")), "divisions"));
    EXPECT_TRUE(has(summary, "preset"));
    EXPECT_FALSE(has(summary, "time_step"));
    EXPECT_FALSE(has(summary, "model_everything"));
    scene.analysis.modelEverything = true;
    scene.stages.push_back(test::dynamic(0.01, 1e-3));
    summary = modelSummaryOf(scene);
    EXPECT_TRUE(has(summary, "model_everything"));
    EXPECT_TRUE(has(summary, "time_step"));
    EXPECT_FALSE(find(summary, "motion of blocks at rest (sleep)"));
    scene.analysis.modelEverything = false;
    EXPECT_TRUE(find(modelSummaryOf(scene), "motion of blocks at rest (sleep)"));
}

}  // namespace
}  // namespace keyblock
