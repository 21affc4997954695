// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene is traded along the settings that it uses, and along no others.
#include "solver/trade/trade_axes.h"

#include "solver/scene/preset.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

std::vector<std::string> namesOf(const std::vector<TradeAxis>& axes) {
    std::vector<std::string> names;
    for (const TradeAxis& axis : axes) names.push_back(axis.name);
    return names;
}

const TradeAxis& axisNamed(const std::vector<TradeAxis>& axes, const std::string& name) {
    return *std::find_if(axes.begin(), axes.end(), [&](const TradeAxis& axis) { return axis.name == name; });
}

TEST(TradeAxes, AreThoseThatTheSceneUses) {
    EXPECT_EQ(namesOf(tradeAxes(inclineScene(30.0, 20.0, 0.1), {12, 0, 0, 2})),
              (std::vector<std::string>{"time_step", "penalty_ratio", "contact", "iteration", "tolerance",
                                        "integration", "sleep_tolerance", "threads", "preset"}));
    Scene still = inclineScene(30.0, 40.0, 0.1);
    still.stages.front() = {};
    still.bolts.resize(1);
    EXPECT_EQ(namesOf(tradeAxes(still, {12, 1, 30, 1})),
              (std::vector<std::string>{"divisions", "increments", "penalty_ratio", "contact", "iteration", "tolerance",
                                        "preset"}));
}

TEST(TradeAxes, ChangeTheSceneAsTheirTextsSay) {
    Scene scene = inclineScene(30.0, 20.0, 0.1);
    scene.bolts.resize(2);
    const std::vector<TradeAxis> axes = tradeAxes(scene, {12, 2, 60, 1});
    const TradeSetting& divisions = axisNamed(axes, "divisions").settings.front();
    EXPECT_EQ(divisions.overrides, (std::vector<std::string>{"bolts[0].divisions=15", "bolts[1].divisions=15"}));
    const TradeSetting& step = axisNamed(axes, "time_step").settings.back();
    EXPECT_EQ(step.overrides, (std::vector<std::string>{"stages[0].time_step=0.000125"}));
    EXPECT_EQ(step.cost, 8.0);
    Scene changed = scene;
    combined("both", {divisions, step}).apply(changed);
    EXPECT_EQ(changed.bolts[1].divisions, 15);
    EXPECT_EQ(changed.stages.front().timeStep, 0.000125);
    changed.bolts = scene.bolts;
    changed.stages.front().timeStep = scene.stages.front().timeStep;
    EXPECT_EQ(changed, scene);
}

/// The strength of a bond per node depends on the divisions, so that other divisions are another bolt.
TEST(TradeAxes, KeepTheDivisionsOfBondsGivenPerNode) {
    Scene scene = inclineScene(30.0, 20.0, 0.1);
    scene.bolts.resize(2);
    scene.bolts[0].anchors.emplace(1);
    scene.bolts[0].anchors->front().per = Per::Node;
    const std::vector<TradeAxis> axes = tradeAxes(scene, {12, 2, 60, 1});
    EXPECT_EQ(axisNamed(axes, "divisions").settings.front().overrides,
              (std::vector<std::string>{"bolts[1].divisions=15"}));
    scene.bolts.pop_back();
    EXPECT_EQ(namesOf(tradeAxes(scene, {12, 1, 30, 1})).front(), "time_step");
}

/// Equal divisions and automatic ones are two series: results of one do not converge to those of the other.
TEST(TradeAxes, GiveSizesToAutomaticDivisionsAlone) {
    Scene scene = inclineScene(30.0, 20.0, 0.1);
    scene.bolts.resize(1);
    const auto sizesOf = [&] {
        const TradeAxis axis = axisNamed(tradeAxes(scene, {12, 1, 30, 1}), "divisions");
        std::vector<double> sizes{axis.ownSize};
        for (const TradeSetting& setting : axis.settings) sizes.push_back(setting.size);
        return sizes;
    };
    EXPECT_EQ(sizesOf(), (std::vector<double>{1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.25}));
    scene.bolts[0].divisions = 50;
    EXPECT_EQ(sizesOf(), (std::vector<double>{0.0, 1.0 / 15, 1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240}));
}

/// Equal divisions are coarser at joints than automatic ones, so the finest ones are automatic too.
TEST(TradeAxes, RefineAutomaticDivisionsEverywhere) {
    Scene scene = inclineScene(30.0, 20.0, 0.1);
    scene.bolts.resize(1);
    const double own = numericsOf(scene.analysis).divisionsFactor;
    const TradeSetting finest = axisNamed(tradeAxes(scene, {12, 1, 30, 1}), "divisions").settings.back();
    Scene changed = scene;
    finest.apply(changed);
    EXPECT_EQ(changed.analysis.divisionsFactor, 4.0 * own);
    EXPECT_FALSE(changed.bolts[0].divisions);
    scene.bolts[0].divisions = 60;
    EXPECT_EQ(axisNamed(tradeAxes(scene, {12, 1, 30, 1}), "divisions").settings.back().text, "240");
}

/// Increments that are coarser than the scene's own are no reference.
/// Otherwise the error of the stiffest preset would be taken for zero.
TEST(TradeAxes, HaveStifferContactsThanAnyPreset) {
    const Scene scene = inclineScene(30.0, 20.0, 0.1);
    Scene stiffest = scene;
    axisNamed(tradeAxes(scene, {12, 0, 0, 1}), "penalty_ratio").settings.back().apply(stiffest);
    for (const Preset preset : {Preset::Sketch, Preset::Draft, Preset::Engineering, Preset::Reference}) {
        Analysis analysis = scene.analysis;
        analysis.preset = preset;
        EXPECT_GT(stiffest.analysis.penaltyRatio.value(), 2.0 * numericsOf(analysis).penaltyRatio);
    }
}

TEST(TradeAxes, KnowTheSizeOfGivenIncrements) {
    Scene still = inclineScene(30.0, 40.0, 0.1);
    still.stages.front() = {};
    EXPECT_EQ(axisNamed(tradeAxes(still, {12, 0, 0, 1}), "increments").ownSize, 0.0);
    still.stages.front().increments = 100;
    const std::vector<TradeAxis> axes = tradeAxes(still, {12, 0, 0, 1});
    EXPECT_EQ(axisNamed(axes, "increments").ownSize, 0.01);
    EXPECT_GT(axisNamed(axes, "increments").settings.back().size, 0.01);
}

TEST(TradeAxes, LeaveOutTheOwnValue) {
    const std::vector<TradeAxis> axes = tradeAxes(inclineScene(30.0, 20.0, 0.1), {12, 0, 0, 1});
    for (const TradeSetting& setting : axisNamed(axes, "integration").settings) EXPECT_NE(setting.text, "shi");
    const TradeAxis& tolerance = axisNamed(axes, "tolerance");
    EXPECT_EQ(tolerance.ownSize, numericsOf(inclineScene(30.0, 20.0, 0.1).analysis).tolerance);
    for (const TradeSetting& setting : tolerance.settings) EXPECT_NE(setting.size, tolerance.ownSize);
}

}  // namespace
}  // namespace keyblock
