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
#include <set>
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

/// These differ when turned by 37°. Rock of 6e13 Pa (guillotine) has contact springs of 2.4e15 N/m: the last digit of a
/// position is half a newton there, and forces differ by 4e-6 of the largest. Where a bond softens (rebar-20), a step is
/// not solved to the last digit (theory, "Divisions"): forces differ by 3e-6 of the largest, and an element that
/// comes within 2e-5 of its yield may or may not be reported.
const std::set<std::string> differWhenTurned{"guillotine", "rebar-20"};

/// The samples that differ when turned, or all others.
std::vector<std::string> sampleNames(bool differ) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(KEYBLOCK_SAMPLES_DIR)) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() != ".json" || differWhenTurned.contains(name) != differ) continue;
        if (isLeftOut(name) || isSection(entry.path())) continue;
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

void expectEqualEvents(const Results& own, const Results& seen) {
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

void expectSame(const std::string& sample, const std::vector<Isometry>& isometries) {
    const Scene scene = strictSample(sample);
    const Results own = runInMemory(scene);
    for (const Isometry& isometry : isometries) {
        if (isometry.angle != 0.0 && !canBeTurned(scene)) continue;
        SCOPED_TRACE(isometry.mirror ? "mirrored" : "turned");
        const Results seen = runInMemory(seenThrough(isometry, scene));
        expectEqualEvents(own, seen);
        EXPECT_EQ(differenceThrough(isometry, own, seen, sameForces), "");
    }
}

class Seen : public testing::TestWithParam<std::string> {};

TEST_P(Seen, TurnedAndInAMirrorIsTheSame) { expectSame(GetParam(), {turn, mirror}); }

INSTANTIATE_TEST_SUITE_P(Samples, Seen, testing::ValuesIn(sampleNames(false)), testName);

class SeenWithRoundOff : public testing::TestWithParam<std::string> {};

TEST_P(SeenWithRoundOff, InAMirrorIsTheSame) { expectSame(GetParam(), {mirror}); }

/// Fails by the differences that are given above.
TEST_P(SeenWithRoundOff, DISABLED_TurnedIsTheSame) { expectSame(GetParam(), {turn}); }

INSTANTIATE_TEST_SUITE_P(Samples, SeenWithRoundOff, testing::ValuesIn(sampleNames(true)), testName);

}  // namespace
}  // namespace keyblock
