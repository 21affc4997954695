// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Good scenes are read as they are meant, written back, and read again the same.
#include "solver/files/scene/scene_file.h"

#include "solver/scene/lookup.h"
#include "tests/problem_list.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

const fs::path goodFolder = fs::path(KEYBLOCK_TEST_DATA_DIR) / "good";

Scene readGood(const fs::path& file, const std::vector<std::string>& overrides = {}) {
    SceneReading reading = readSceneFile(file, overrides);
    EXPECT_TRUE(reading.scene) << test::problemList(reading.problems);
    return reading.scene.value_or(Scene{});
}

std::vector<fs::path> scenesIn(const fs::path& folder) {
    std::vector<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json")
            scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

const Problem* problemAt(const std::vector<Problem>& problems, const std::string& pointer) {
    const auto found = std::find_if(problems.begin(), problems.end(),
                                    [&](const Problem& problem) { return problem.pointer == pointer; });
    return found == problems.end() ? nullptr : &*found;
}

TEST(SceneFile, EverySceneIsReadBackAsItWasWritten) {
    std::vector<fs::path> scenes = scenesIn(goodFolder);
    const std::vector<fs::path> samples = scenesIn(KEYBLOCK_SAMPLES_DIR);
    scenes.insert(scenes.end(), samples.begin(), samples.end());
    ASSERT_GE(scenes.size(), 3u);
    for (const fs::path& file : scenes) {
        const Scene scene = readGood(file);
        const std::string text = sceneText(scene);
        const SceneReading again = readSceneText(text, "again", {}, file.parent_path());
        ASSERT_TRUE(again.scene) << file << "\n" << test::problemList(again.problems);
        EXPECT_TRUE(*again.scene == scene) << file << "\n" << text;
        EXPECT_EQ(sceneText(*again.scene), text) << file;
    }
}

/// What a run store keeps needs no other file, and says the same.
TEST(SceneFile, AWholeTextHoldsItsRecords) {
    const Scene scene = readGood(goodFolder / "every-field.json");
    EXPECT_EQ(sceneText(scene).find("[0.25, 0.5]"), std::string::npos);
    const SceneReading again = readSceneText(wholeSceneText(scene), "again", {}, "no/such/folder");
    ASSERT_TRUE(again.scene) << test::problemList(again.problems);
    EXPECT_TRUE(*again.scene == scene);
    EXPECT_EQ(sceneHash(*again.scene), sceneHash(scene));
    Scene other = scene;
    other.stages.at(1).baseAcceleration->record.at(1).second = 0.6;
    EXPECT_NE(sceneHash(other), sceneHash(scene));
    EXPECT_EQ(sceneText(other), sceneText(scene));
}

TEST(SceneFile, RecordsLieBesideTheScene) {
    const test::ScratchFolder folder;
    fs::create_directory(folder.path() / "sub");
    test::putContent(folder.path() / "sub/motion.csv", "time_s,a\n0,0\n0.5,1\n1,0\n");
    test::putContent(folder.path() / "sub/scene.json", R"({"format": "keyblock-scene", "version": 1,
        "materials": {"rock": {"density": 1, "youngs_modulus": 1, "poissons_ratio": 0}},
        "blocks": [{"points": [[0, 0], [1, 0], [0, 1]], "material": "rock"}],
        "supports": [{"block_at": [0.2, 0.2]}],
        "stages": [{"name": "a", "kind": "dynamic", "duration": 1,
                    "base_acceleration": {"file": "motion.csv", "axis": "x", "factor": 2}}]})");
    const SceneReading reading = readSceneFile(folder.path() / "sub/scene.json");
    ASSERT_TRUE(reading.scene) << test::problemList(reading.problems);
    EXPECT_EQ(reading.scene->stages[0].baseAcceleration->record.size(), 3u);
    const Problem* baseline = problemAt(reading.problems, "/stages/0/base_acceleration/file");
    ASSERT_NE(baseline, nullptr);
    EXPECT_EQ(baseline->severity, Severity::Warning);
    EXPECT_NE(baseline->message.find("velocity of 1 m/s"), std::string::npos) << baseline->message;
    EXPECT_NE(baseline->message.find("displacement of 0.5 m"), std::string::npos) << baseline->message;
}

TEST(SceneFile, ReadsWhatTheFileSays) {
    const Scene scene = readGood(goodFolder / "every-field.json");
    EXPECT_EQ(scene.analysis.plane, Plane::Stress);
    EXPECT_EQ(scene.analysis.gravity, Point(0, -9.81));
    EXPECT_EQ(scene.materials.at(1).first, "ore/body");
    EXPECT_EQ(scene.blocks.at(0).initialStress, (Stress{-1e6, -2e6, 1e5}));
    EXPECT_EQ(scene.blocks.at(1).name, "");
    EXPECT_EQ(scene.supports.at(2).fix, Fix::XY);
    EXPECT_EQ(scene.stages.at(0).motions.at(0).axis, Point(3, 4));
    EXPECT_EQ(scene.stages.at(0).motions.at(0).rotation, Rotation::Free);
    EXPECT_FALSE(scene.stages.at(0).continueAfterCollapse);
    EXPECT_EQ(scene.stages.at(0).until.maxSteps, 500);
    EXPECT_EQ(scene.stages.at(1).integration, Integration::Shi);
    EXPECT_EQ(scene.stages.at(0).set.at(0).cohesion, 5e4);
    EXPECT_FALSE(scene.stages.at(0).set.at(0).tensileStrength);
    EXPECT_EQ(scene.stages.at(1).baseAcceleration->record, (Table{{0.0, 0.0}, {0.25, 0.5}, {0.5, -0.1}}));
    EXPECT_EQ(scene.stages.at(0).bodyAcceleration->value, 0.15);
    EXPECT_EQ(scene.stages.at(0).bodyAcceleration->factor, 9.81);
    EXPECT_EQ(scene.safety.boltForces, BoltForces::Frozen);
    EXPECT_EQ(scene.stages.at(1).bodyAcceleration->sine->phase, 0.1);
    EXPECT_FALSE(scene.stages.at(1).bodyAcceleration->value);
    EXPECT_EQ(scene.stages.at(2).baseAcceleration->record.size(), 3u);
    EXPECT_FALSE(scene.stages.at(2).bodyAcceleration);
    EXPECT_EQ(scene.limits.steps, 100000);
    EXPECT_EQ(scene.monitors.at(1).axis, Point(0, 1));
    EXPECT_EQ(scene.monitors.at(3).quantity, BoltQuantity::Slip);
    EXPECT_EQ(scene.output.every, 0.05);
    const BoltType& mine = boltTypeOf(scene, scene.bolts.at(0));
    ASSERT_EQ(mine.anchors.size(), 5u);
    EXPECT_EQ(mine.anchors[1].at, (BoltPlace{true, 0.0}));
    EXPECT_EQ(mine.anchors[3].softeningSlip, 2e-3);
    EXPECT_EQ(mine.anchors[4].onFailure, OnFailure::BoltLost);
    EXPECT_EQ(mine.steelDynamicFactor, 1.1);
    EXPECT_EQ(mine.plateDynamicFactor, 0.9);
    EXPECT_EQ(scene.bolts.at(0).dynamicFactor, 0.8);
    EXPECT_EQ(scene.bolts.at(0).steelDynamicFactor, 1.05);
    EXPECT_EQ(scene.bolts.at(0).plateDynamicFactor, 0.7);
    EXPECT_FALSE(scene.bolts.at(1).plateDynamicFactor);
}

TEST(SceneFile, FollowsLikeThroughOwnAndBuiltInTypes) {
    const Scene scene = readGood(goodFolder / "every-field.json");
    const BoltType& too = boltTypeOf(scene, scene.bolts.at(1));
    EXPECT_EQ(too.like, "mine-thick");
    EXPECT_DOUBLE_EQ(too.diameter, 0.03) << "from mine-thick, which stands after it";
    EXPECT_DOUBLE_EQ(too.density, 7800) << "from mine";
    EXPECT_TRUE(too.anchors.empty()) << "replaced as a whole";
    EXPECT_DOUBLE_EQ(too.plate.width, 0.3);
    EXPECT_DOUBLE_EQ(too.plate.normalStiffness, 2e9) << "an object keeps the members that are not given anew";
    EXPECT_FALSE(too.tensileStrength);
    EXPECT_FALSE(too.sources.contains("diameter")) << "the source was that of another number";
    const BoltType& unbreakable = boltTypeOf(scene, scene.bolts.at(2));
    EXPECT_TRUE(unbreakable.steel.empty());
    EXPECT_EQ(unbreakable.boltClass, BoltClass::DMC);
    EXPECT_TRUE(unbreakable.sources.contains("anchors"));
    EXPECT_TRUE(boltTypeOf(scene, scene.bolts.at(3)).builtIn);
}

TEST(SceneFile, WarnsOfASceneWithoutStages) {
    const SceneReading reading = readSceneFile(goodFolder / "smallest.json");
    EXPECT_TRUE(reading.scene);
    ASSERT_EQ(reading.problems.size(), 1u);
    EXPECT_EQ(reading.problems[0].severity, Severity::Warning);
}

TEST(SceneFile, AMisspeltProfileIsOneProblem) {
    const SceneReading reading = readSceneText(R"({"format": "keyblock-scene", "version": 1,
        "materials": {"rock": {"density": 2700, "youngs_modulus": 1e10, "poissons_ratio": 0.2}},
        "domain": {"boundary": [[-9, -9], [9, -9], [9, 9], [-9, 9]], "material": "rock"},
        "tunnels": [{"name": "T", "profile": "d-shap", "center": [0, 0], "width": 4, "height": 4}],
        "stages": [{"name": "a"}]})", "scene.json");
    ASSERT_EQ(reading.problems.size(), 1u) << reading.problems[1].pointer;
    EXPECT_EQ(reading.problems[0].pointer, "/tunnels/0/profile");
}

TEST(SceneFile, TellsEverythingAtOnceWithLines) {
    const std::string text = R"({
"format": "keyblock-scene",
"version": 1,
"materials": {"rock": {"density": 0,
"youngs_modulus": "a"}},
"stages": [{"name": "a",
"kind": "static",
"loads": [{}]}],
"blocks": [{"points": [[0,0],[1,0],[1,1]], "material": "rok"}],
"colour": 1})";
    const SceneReading reading = readSceneText(text, "scene.json");
    const std::vector<std::pair<std::string, int>> expected{{"/materials/rock/density", 4},
                                                            {"/materials/rock/poissons_ratio", 4},
                                                            {"/materials/rock/youngs_modulus", 5},
                                                            {"/stages/0/loads/0", 8},
                                                            {"/blocks/0/material", 9},
                                                            {"/colour", 10}};
    EXPECT_EQ(reading.problems.size(), expected.size()) << test::problemList(reading.problems);
    for (const auto& [pointer, line] : expected) {
        const Problem* problem = problemAt(reading.problems, pointer);
        ASSERT_NE(problem, nullptr) << pointer << "\n" << test::problemList(reading.problems);
        EXPECT_EQ(problem->line, line) << pointer;
        EXPECT_EQ(problem->file, "scene.json");
    }
}

TEST(SceneFile, OverridesReachEveryPlaceInEverySpelling) {
    const Scene scene = readGood(
        goodFolder / "every-field.json",
        {"stages[0].increments=40", "stages/1/duration=2", "/materials/ore~1body/density=5000", "bolts[0].plate=none",
         "bolts[0].pretension=0",
         "title=Say \"what\" you like", "output={\"frames\": 7}", "bolts[1].divisions=12"});
    EXPECT_EQ(scene.stages[0].increments, 40);
    EXPECT_DOUBLE_EQ(scene.stages[1].duration, 2.0);
    EXPECT_DOUBLE_EQ(scene.materials[1].second.density, 5000);
    EXPECT_EQ(scene.bolts[0].plate, PlateKind::None);
    EXPECT_EQ(scene.title, "Say \"what\" you like");
    EXPECT_EQ(scene.output.frames, 7);
    EXPECT_FALSE(scene.output.every) << "the object was replaced as a whole";
    EXPECT_EQ(scene.bolts[1].divisions, 12);
}

TEST(SceneFile, OverridesMakeObjectsOnTheWay) {
    const Scene scene = readGood(goodFolder / "smallest.json", {"analysis.tolerance=1e-8"});
    EXPECT_EQ(scene.analysis.tolerance, 1e-8);
}

TEST(SceneFile, MistakesInOverridesNameTheOption) {
    for (const std::string option : {"stages[7].increments=3", "stages[0].increments=many", "title", "=3",
                                     "analysis.penalty=3", "analysis.thickness=-1", "stages[0]..name=x",
                                     "title.text=x", "materials={\"a\": 1, \"a\": 2}"}) {
        const SceneReading reading = readSceneFile(goodFolder / "every-field.json", std::vector<std::string>{option});
        EXPECT_FALSE(reading.scene) << option;
        const bool isNamed = std::any_of(reading.problems.begin(), reading.problems.end(), [&](const Problem& problem) {
            return problem.file == "--set " + option && problem.severity == Severity::Error;
        });
        EXPECT_TRUE(isNamed) << option << "\n" << test::problemList(reading.problems);
    }
}

TEST(SceneFile, WritesOnlyWhatDiffersFromTheDefaults) {
    Scene scene;
    EXPECT_EQ(sceneText(scene), "{\n  \"format\": \"keyblock-scene\",\n  \"version\": 1\n}\n");
    scene.analysis.tolerance = 0.1 + 0.2;
    EXPECT_NE(sceneText(scene).find("\"analysis\": { \"tolerance\": 0.30000000000000004 }"), std::string::npos)
        << sceneText(scene);
}

TEST(SceneFile, WritesToADisk) {
    const test::ScratchFolder scratch;
    const Scene scene = readGood(goodFolder / "every-field.json");
    const fs::path folder = scratch.path() / "copies";  // with the record where the scene says it is
    fs::create_directories(folder);
    fs::copy(goodFolder / "../records", scratch.path() / "records");
    writeSceneFile(folder / "copy.json", scene);
    EXPECT_TRUE(readGood(folder / "copy.json") == scene);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}), 1);
}

TEST(SceneFile, TakesItsRecordsAlongToAnotherFolder) {
    const test::ScratchFolder scratch;
    const Scene scene = readGood(goodFolder / "every-field.json");
    writeSceneFile(scratch.path() / "elsewhere.json", scene);
    EXPECT_TRUE(readGood(scratch.path() / "elsewhere.json") == scene);
}

TEST(SceneFile, AnOwnTypeStandsBeforeABuiltInOfTheSameName) {
    const Scene scene = readGood(goodFolder / "every-field.json",
                                 {R"(bolt_types.split-set-47={"diameter": 0.05, "youngs_modulus": 2e11})"});
    const BoltType& type = boltTypeOf(scene, scene.bolts.at(3));
    EXPECT_FALSE(type.builtIn);
    EXPECT_DOUBLE_EQ(type.diameter, 0.05);
}

}  // namespace
}  // namespace keyblock
