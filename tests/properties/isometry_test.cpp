// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every sample in a mirror, and turned by 37° with its gravity: the same forces
// to 1e-6 of the largest, and the same events in the same order. The ten bars under
// pull and shear at an angle take minutes at this tolerance: three are in the suite,
// all of them where KEYBLOCK_SERIES is set:
//   KEYBLOCK_SERIES=1 build/dev/tests/properties_tests --gtest_filter='*angle*'
#include "tests/properties/isometry.h"

#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

constexpr double sameForces = 1e-6;  // of the largest
constexpr Isometry turn{false, 37.0 * std::numbers::pi / 180.0};
constexpr Isometry mirror{true, 0.0};

/// A section is drawn from spacings and seeds, which no mirror turns round.
bool isSection(const fs::path& sample) {
    const SceneReading reading = readSceneFile(sample);
    return reading.scene && reading.scene->domain;
}

bool isLeftOut(const std::string& name) {
    if (!name.starts_with("angle-") || std::getenv("KEYBLOCK_SERIES")) return false;
    return name != "angle-rebar-40" && name != "angle-dbolt-20" && name != "angle-rebar-00";
}

std::vector<std::string> sampleNames() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(KEYBLOCK_SAMPLES_DIR)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() != ".json" || isLeftOut(name) || isSection(entry.path())) continue;
        names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

Scene strictSample(const std::string& name) {
    SceneReading reading = readSceneFile(fs::path(KEYBLOCK_SAMPLES_DIR) / (name + ".json"));
    Scene scene = reading.scene.value();
    scene.analysis.tolerance = 1e-10;
    for (Stage& stage : scene.stages) stage.until.unbalanced = 1e-10;
    return scene;
}

void expectSameEvents(const Results& own, const Results& seen) {
    ASSERT_EQ(own.events.size(), seen.events.size());
    for (std::size_t i = 0; i < own.events.size(); ++i) {
        EXPECT_EQ(own.events[i].kind, seen.events[i].kind) << i;
        EXPECT_EQ(own.events[i].node, seen.events[i].node) << i;
        EXPECT_EQ(own.events[i].element, seen.events[i].element) << i;
    }
}

std::string testName(const testing::TestParamInfo<std::string>& sample) {
    std::string name = sample.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

class Seen : public testing::TestWithParam<std::string> {};

/// Rock of 6e13 Pa has contact springs of 2.4e15 N/m: the last digit of a position is half a newton there. Where a bond
/// softens, a step is not solved to the last digit (theory, "Curves that fall"); an element that comes within 2e-5 of its
/// yield then may or may not be reported.
const std::map<std::string, std::string> knownToDiffer{
    {"guillotine", "4e-6 of the largest force, which is round-off"},
    {"rebar-20", "3e-6 of the largest force and one yield, within 2e-5 of the limit of its element"}};

TEST_P(Seen, TurnedAndInAMirrorIsTheSame) {
    const Scene scene = strictSample(GetParam());
    const Results own = runInMemory(scene);
    for (const Isometry& isometry : {turn, mirror}) {
        if (isometry.angle != 0.0 && !canBeTurned(scene)) continue;
        if (isometry.angle != 0.0 && knownToDiffer.contains(GetParam())) continue;
        SCOPED_TRACE(isometry.mirror ? "mirrored" : "turned");
        const Results seen = runInMemory(seenThrough(isometry, scene));
        expectSameEvents(own, seen);
        EXPECT_EQ(differenceThrough(isometry, own, seen, sameForces), "");
    }
    const auto known = knownToDiffer.find(GetParam());
    if (known != knownToDiffer.end()) GTEST_SKIP() << "turned by 37° it differs by " << known->second;
}

INSTANTIATE_TEST_SUITE_P(Samples, Seen, testing::ValuesIn(sampleNames()), testName);

}  // namespace
}  // namespace keyblock
