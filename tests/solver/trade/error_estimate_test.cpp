// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimated errors of scenes whose results have closed forms, and of what is not a number.
#include "solver/trade/error_estimate.h"

#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/run_store/stored_estimate.h"
#include "solver/results/quantity.h"
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

/// A block that slides down a slope, with steps of first-order error.
Scene coarseSlide() {
    Scene scene = inclineScene(30.0, 20.0, 0.05);
    scene.analysis.integration = Integration::BackwardEuler;
    scene.stages.front().integration.reset();
    scene.stages.front().timeStep = 0.005;
    scene.quantities = {"last slider.u", "stands", "energy_error"};
    return scene;
}

std::optional<ErrorEstimate> estimateOf(const Scene& scene, std::vector<std::string>& labels, bool stops = false) {
    return estimateErrors(scene, runInMemory(scene),
                          [&](const Scene& fine, const SceneCut& cut, const std::string& label, Sink& sink) {
                              labels.push_back(label);
                              Control control;
                              control.stop = stops;
                              run(fine, sink, control, {1, &cut});
                          });
}

TEST(ErrorEstimate, OfASlidingBlockIsItsTrueError) {
    const Scene scene = coarseSlide();
    std::vector<std::string> labels;
    const std::optional<ErrorEstimate> estimate = estimateOf(scene, labels);
    ASSERT_TRUE(estimate);
    EXPECT_EQ(labels, (std::vector<std::string>{"half the time step"}));
    EXPECT_EQ(estimate->refinements, labels);
    const QuantityEstimate& slide = estimate->quantities[0];
    const double exact = 0.5 * gravity * (0.5 - std::cos(30.0 * degree) * std::tan(20.0 * degree)) * 0.05 * 0.05;
    const double error = std::abs(slide.value.value() - exact);
    EXPECT_GT(error, 0.02 * exact);  // coarse enough for the estimate to mean something
    EXPECT_NEAR(slide.error.value(), error, 0.1 * error);
    EXPECT_EQ(estimate->quantities[1].error, 0.0);
    EXPECT_EQ(estimate->quantities[2].remark, "an error itself");
}

TEST(ErrorEstimate, EndsWithItsRun) {
    std::vector<std::string> labels;
    EXPECT_FALSE(estimateOf(coarseSlide(), labels, true));
}

/// A bar pulled out of an elastic bond, in one static stage.
Scene pulledBar(std::optional<int> divisions, Per per) {
    Scene scene = paperRebar(200e9, 50e3, 60, 20e9, 1e-4, 4);
    scene.bolts.front().divisions = divisions;
    for (BoltType& type : scene.boltTypes)
        for (Anchor& anchor : type.anchors) anchor.per = per;
    return scene;
}

std::vector<std::string> textsOf(const Scene& scene) {
    std::vector<std::string> texts;
    for (const Refinement& refinement : refinementsOf(scene, runInMemory(scene))) texts.push_back(refinement.text);
    return texts;
}

TEST(ErrorEstimate, RefinesTheMostLoadedBolt) {
    const Scene given = pulledBar(30, Per::Length);
    const std::string name = given.bolts.front().name;
    EXPECT_EQ(textsOf(given),
              (std::vector<std::string>{"twice the increments", "twice the divisions of bolt " + name}));
    EXPECT_EQ(refinementsOf(given, runInMemory(given)).back().scene.bolts.front().divisions, 60);
    EXPECT_EQ(textsOf(pulledBar({}, Per::Length)).back(), "twice the divisions of bolts with automatic divisions");
}

TEST(ErrorEstimate, LeavesABondPerNodeAsItIs) {
    EXPECT_EQ(textsOf(pulledBar(30, Per::Node)), (std::vector<std::string>{"twice the increments"}));
}

TEST(StoredEstimate, IsReadAsItWasWritten) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "slide.kbrun";
    RunStoreWriter store(path, false);
    Control control;
    run(coarseSlide(), store, control);
    store.close();
    EXPECT_FALSE(storedEstimate(path));
    const ErrorEstimate estimate{{"half the time step"},
                                 {{"last slider.u", 0.1, 1.0 / 3.0, ""}, {"order debonding", {}, {}, "no \"event\""}}};
    storeEstimate(path, {{"another"}, {}});
    storeEstimate(path, estimate);
    EXPECT_EQ(storedEstimate(path), estimate);
}

}  // namespace
}  // namespace keyblock
