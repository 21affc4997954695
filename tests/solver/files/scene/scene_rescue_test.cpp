// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of a scene with errors, what can be read is read; of one without, all of it.
#include "tests/scratch_folder.h"

#include "solver/files/scene/scene_file.h"
#include "solver/files/scene/scene_rescue.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

constexpr char broken[] = R"({
  "title": "half",
  "materials": { "rock": { "density": 2600, "youngs_modulus": "soft", "poissons_ratio": 0.25 },
                 "granite": { "density": 2700, "youngs_modulus": 6e10, "poissons_ratio": 0.25 } },
  "blocks": [
    { "points": [[0, 0], [1, 0], [1, 1]], "material": "granite" },
    { "points": [[0, 0], [1, 0], "here"], "material": "granite" },
    { "material": "granite" },
    { "points": [[2, 0], [3, 0], [3, 1]], "material": "granite", "colour": "red" }
  ]
})";

TEST(SceneRescue, ObjectsThatLackSomethingAreLeftOutAndNamed) {
    const SceneRescue rescue = rescueSceneText(broken, "half.json");
    ASSERT_TRUE(rescue.scene);
    EXPECT_EQ(rescue.scene->title, "half");
    ASSERT_EQ(rescue.scene->blocks.size(), 2u);
    EXPECT_EQ(rescue.scene->blocks[1].points[0], Point(2, 0));
    EXPECT_EQ(rescue.leftOut, (std::vector<std::string>{"/blocks/1", "/blocks/2", "/blocks/3/colour", "/materials/rock"}));
    EXPECT_TRUE(std::ranges::any_of(rescue.problems, [](const Problem& p) { return p.line == 7; }));
    EXPECT_FALSE(rescue.brokeOff);
    EXPECT_FALSE(rescue.isWhole);
}

TEST(SceneRescue, NamesThatLeadNowhereAreKept) {
    constexpr char text[] = R"({ "format": "keyblock-scene", "version": 1, "bolts": [{ "name": "B1", "type": "theirs", "head": [0, 0], "far_end": [0, 2] }],
        "stages": [{ "name": "shake", "kind": "dynamic", "duration": 1, "time_step": 0.01,
                     "body_acceleration": { "axis": "x", "file": "gone.csv" } }] })";
    const SceneRescue rescue = rescueSceneText(text, "theirs.json", "no/such/folder");
    ASSERT_TRUE(rescue.scene);
    EXPECT_TRUE(rescue.isWhole) << "written, it says the same";
    EXPECT_EQ(rescue.problems.size(), 2u);
    EXPECT_EQ(rescue.scene->bolts.at(0).type, "theirs");
    EXPECT_EQ(rescue.scene->stages.at(0).bodyAcceleration->file, "gone.csv");
}

TEST(SceneRescue, OfATextThatBreaksOffWhatStandsBeforeIsRead) {
    const std::string whole = test::contentOf(KEYBLOCK_SAMPLES_DIR "/tower-100.json");
    const std::size_t all = rescueSceneText(whole, "t").scene->blocks.size();
    const SceneRescue rescue = rescueSceneText(std::string_view(whole).substr(0, whole.size() / 2), "t");
    ASSERT_TRUE(rescue.scene);
    EXPECT_TRUE(rescue.brokeOff);
    EXPECT_FALSE(rescue.problems.empty());
    EXPECT_GT(rescue.scene->blocks.size(), 10u);
    EXPECT_LT(rescue.scene->blocks.size(), all);
}

TEST(SceneRescue, AnyCutGivesAnAnswer) {
    const std::string whole = test::contentOf(KEYBLOCK_SAMPLES_DIR "/shaken-incline.json");
    const std::size_t lastBrace = whole.rfind('}');
    for (std::size_t end = 0; end <= lastBrace; ++end) {
        const SceneRescue rescue = rescueSceneText(std::string_view(whole).substr(0, end), "cut", KEYBLOCK_SAMPLES_DIR);
        ASSERT_FALSE(rescue.problems.empty()) << "cut after " << end << " bytes";
        ASSERT_FALSE(rescue.isWhole) << "cut after " << end << " bytes";
        ASSERT_TRUE(!rescue.scene || rescue.brokeOff) << "cut after " << end << " bytes";
    }
}

TEST(SceneRescue, AWholeSceneIsReadAsItIs) {
    for (const char* sample : {"/drift-bolted.json", "/shaken-record.json", "/drop-roofex.json"}) {
        const std::string path = std::string(KEYBLOCK_SAMPLES_DIR) + sample;
        const SceneRescue rescue = rescueSceneText(test::contentOf(path), path, KEYBLOCK_SAMPLES_DIR);
        ASSERT_TRUE(rescue.scene);
        EXPECT_TRUE(rescue.leftOut.empty());
        EXPECT_EQ(wholeSceneText(*rescue.scene), wholeSceneText(*readSceneFile(path).scene));
    }
}

TEST(SceneRescue, WhatIsNoSceneIsNone) {
    EXPECT_FALSE(rescueSceneText("[1, 2]", "list").scene);
    EXPECT_FALSE(rescueSceneText("", "empty").scene);
    EXPECT_FALSE(rescueSceneText(R"({"format": "other"})", "other").scene);
}

}  // namespace
}  // namespace keyblock
