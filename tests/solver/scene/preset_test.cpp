// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Presets determine the numerical settings that a scene leaves out, and no others.
#include "solver/scene/preset.h"

#include "solver/engine/setup/make_model.h"
#include "solver/scene/automatic.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/preset_data.h"
#include "solver/scene/structures.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

constexpr Preset all[]{Preset::Sketch, Preset::Draft, Preset::Engineering, Preset::Reference};

Analysis with(Preset preset) {
    Analysis analysis;
    analysis.preset = preset;
    return analysis;
}

TEST(Presets, SetFieldsOfTheAnalysisWithinTheirRanges) {
    ASSERT_EQ(presetData().size(), presetWords.size());
    const Analysis analysis;
    for (const PresetData& data : presetData()) {
        EXPECT_FALSE(data.help.empty());
        for (const auto& [key, value] : data.settings) {
            const Field* field = findField(structureOf(&analysis), key);
            ASSERT_NE(field, nullptr) << key;
            EXPECT_TRUE(field->nullable) << key;
            if (const double* number = std::get_if<double>(&value)) EXPECT_TRUE(contains(field->range, *number)) << key;
            else
                EXPECT_NE(std::find(field->words.begin(), field->words.end(), std::get<std::string>(value)),
                          field->words.end())
                    << key;
        }
    }
}

TEST(Presets, EngineeringHasTheDefaultsOfTheFormat) {
    const Numerics numerics = numericsOf({});
    EXPECT_EQ(numerics.contact, ContactMethod::Penalty);
    EXPECT_EQ(numerics.penaltyRatio, 40.0);
    EXPECT_EQ(numerics.tolerance, 1e-4);
    EXPECT_EQ(numerics.maxPasses, 40);
    EXPECT_EQ(numerics.sleepTolerance, 1e-3);
    EXPECT_EQ(numerics.timeStepFactor, 1.0);
    EXPECT_EQ(numerics.divisionsFactor, 1.0);
}

TEST(Presets, AreFinerFromOneToTheNext) {
    for (std::size_t i = 0; i + 1 < std::size(all); ++i) {
        const Numerics coarse = numericsOf(with(all[i])), fine = numericsOf(with(all[i + 1]));
        EXPECT_GE(coarse.tolerance, fine.tolerance);
        EXPECT_GE(coarse.sleepTolerance, fine.sleepTolerance);
        EXPECT_GT(coarse.timeStepFactor, fine.timeStepFactor);
        EXPECT_LE(coarse.divisionsFactor, fine.divisionsFactor);
        EXPECT_LE(coarse.penaltyRatio, fine.penaltyRatio);
    }
}

TEST(Presets, GiveWayToTheScene) {
    Analysis analysis = with(Preset::Sketch);
    EXPECT_EQ(presetText(analysis), "sketch");
    analysis.tolerance = 1e-5;
    EXPECT_EQ(numericsOf(analysis).tolerance, 1e-5);
    EXPECT_EQ(presetText(analysis), "sketch, 1 setting changed");
    analysis.contact = ContactMethod::AugmentedLagrangian;
    EXPECT_EQ(numericsOf(analysis).contact, ContactMethod::AugmentedLagrangian);
    EXPECT_EQ(presetText(analysis), "sketch, 2 settings changed");
    analysis.contact = ContactMethod::Penalty;  // as the preset has it
    EXPECT_EQ(presetText(analysis), "sketch, 1 setting changed");
    for (const SettingInUse& setting : settingsInUse(analysis))
        EXPECT_EQ(setting.given, setting.field->key == "tolerance" || setting.field->key == "contact");
}

TEST(Presets, OnlySketchWarns) {
    for (const Preset preset : all) EXPECT_EQ(presetWarning(preset).empty(), preset != Preset::Sketch);
}

TEST(Presets, ScaleAutomaticTimeStepsOnly) {
    Scene scene = inclineScene(30.0, 20.0, 0.1);
    scene.stages.front().duration = 1.0;
    const double usual = automaticTimeStep(scene, scene.stages.front());
    scene.analysis.preset = Preset::Sketch;
    EXPECT_DOUBLE_EQ(automaticTimeStep(scene, scene.stages.front()), usual * numericsOf(scene.analysis).timeStepFactor);
}

std::size_t nodesOf(Preset preset, Per per, std::optional<int> divisions) {
    Scene scene = paperRebar(200e9, 5e3, 60, 20e9, 1e-3, 1);
    scene.bolts.front().divisions = divisions;
    for (Anchor& anchor : scene.boltTypes.front().anchors) anchor.per = per;
    scene.analysis.preset = preset;
    return makeModel(scene).bolts.front().s.size();
}

TEST(Presets, ScaleAutomaticDivisionsOnly) {
    EXPECT_EQ(nodesOf(Preset::Sketch, Per::Length, 60), 61u);
    const double usual = static_cast<double>(nodesOf(Preset::Engineering, Per::Length, {}) - 1);
    EXPECT_NEAR(static_cast<double>(nodesOf(Preset::Reference, Per::Length, {}) - 1), 2.0 * usual, 0.1 * usual);
    EXPECT_NEAR(static_cast<double>(nodesOf(Preset::Sketch, Per::Length, {}) - 1), 0.5 * usual, 0.1 * usual);
}

TEST(Presets, LeaveTheDivisionsOfABondPerNode) {
    EXPECT_EQ(nodesOf(Preset::Sketch, Per::Node, {}), nodesOf(Preset::Engineering, Per::Node, {}));
    EXPECT_EQ(nodesOf(Preset::Reference, Per::Node, {}), nodesOf(Preset::Engineering, Per::Node, {}));
}

}  // namespace
}  // namespace keyblock
