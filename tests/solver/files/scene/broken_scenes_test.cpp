// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every broken scene of tests/data/broken is refused, at the right place, in
// words that name the mistake, and with nothing reported twice.
#include "solver/files/scene/scene_file.h"
#include "tests/problem_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <ostream>
#include <set>
#include <string>

namespace keyblock {
namespace {

const std::filesystem::path folder = std::filesystem::path(KEYBLOCK_TEST_DATA_DIR) / "broken";

struct BrokenScene {
    std::string file;
    std::string pointer;
    std::string word;  // in the message or the remedy
};

void PrintTo(const BrokenScene& scene, std::ostream* out) { *out << scene.file; }

const std::vector<BrokenScene>& brokenScenes() {
    static const std::vector<BrokenScene> scenes{
        {"empty", "", "end of input"},
        {"truncated", "/supports/0", "is incomplete"},
        {"not-json", "", "not valid JSON"},
        {"byte-order-mark", "", "byte order mark"},
        {"utf-16", "", "UTF-16"},
        {"invalid-utf-8", "/title", "UTF-8"},
        {"nan", "/materials/rock/density", "NaN"},
        {"infinity", "/materials/rock/density", "Infinity"},
        {"overflow", "/materials/rock/density", "overflow"},
        {"missing-comma", "", "not valid JSON"},
        {"trailing-comma", "", "not valid JSON"},
        {"trailing-text", "", "not valid JSON"},
        {"comment", "", "not valid JSON"},
        {"single-quotes", "", "not valid JSON"},
        {"control-character", "/title", "not valid JSON"},
        {"deep-brackets", "", "deep"},
        {"root-is-list", "", "a list"},
        {"root-is-null", "", "null"},
        {"duplicate-key", "/version", "twice"},
        {"duplicate-material", "/materials/rock", "twice"},
        {"duplicate-in-block", "/blocks/0/name", "twice"},
        {"other-format", "/format", "not a Keyblock scene"},
        {"missing-format", "/format", "no 'format'"},
        {"version-99", "/version", "newer"},
        {"version-0", "/version", "no such version"},
        {"version-text", "/version", "no such version"},
        {"missing-version", "/version", "no 'version'"},
        {"unknown-key", "/titel", "'title'"},
        {"unknown-key-in-block", "/blocks/0/pionts", "'points'"},
        {"safety-of-plates", "/safety/reduce", "'bonds'"},
        {"safety-without-tolerance", "/safety/tolerance", "out of range"},
        {"unknown-preset", "/analysis/preset", "'sketch', 'draft'"},
        {"missing-points", "/blocks/0/points", "no 'points'"},
        {"missing-density", "/materials/rock/density", "no 'density'"},
        {"missing-head", "/bolts/0/head", "no 'head'"},
        {"missing-stage-name", "/stages/0/name", "no 'name'"},
        {"text-for-number", "/materials/rock/density", "a number"},
        {"number-for-text", "/blocks/0/material", "a text"},
        {"list-for-object", "/materials", "an object"},
        {"object-for-list", "/blocks", "a list"},
        {"null-for-number", "/analysis/thickness", "a number"},
        {"flag-for-text", "/title", "a text"},
        {"point-of-three", "/bolts/0/head", "two numbers"},
        {"points-of-texts", "/blocks/0/points/1", "two numbers"},
        {"fraction-for-integer", "/bolts/0/divisions", "whole number"},
        {"block-is-null", "/blocks/0", "an object"},
        {"quantity-is-number", "/quantities", "list of texts"},
        {"axis-z", "/stages/0/motions/0/axis", R"("x", "y")"},
        {"unknown-plane", "/analysis/plane", "'strain'"},
        {"unknown-kind", "/stages/0/kind", "'dynamic'"},
        {"cells-of-no-size", "/blocks/1/sub_blocks/size", "out of range"},
        {"cells-without-size", "/blocks/1/sub_blocks/size", "no 'size'"},
        {"cells-too-many", "/blocks/1/sub_blocks/size", "1000000"},
        {"cells-as-number", "/blocks/1/sub_blocks", "an object"},
        {"cells-named-twice", "/blocks/1/name", "'right:3'"},
        {"plate-block", "/bolts/0/head", "m from the nearest"},
        {"plate-on-corner", "/bolts/0/head", "corner"},
        {"plate-in-notch", "/bolts/0/head", "overlap rock"},
        {"plate-behind", "/bolts/0/head", "does not leave the rock"},
        {"plates-overlap", "/bolts/1/head", "bolt 'B'"},
        {"unknown-integration", "/analysis/integration", "'backward-euler'"},
        {"rho-inf-above-1", "/analysis/rho_inf", "1"},
        {"negative-damping", "/analysis/damping/stiffness", "0"},
        {"pretension-without-plate", "/bolts/0/pretension", "no plate"},
        {"pretension-in-the-air", "/bolts/0/pretension", "no rock"},
        {"pretension-in-motion", "/bolts/0/pretension", "static stage"},
        {"zero-crushing-strength", "/joint_materials/smooth/crushing_strength", "out of range"},
        {"unknown-contact", "/analysis/contact", "'augmented-lagrangian'"},
        {"unknown-iteration", "/analysis/iteration", "'open-close'"},
        {"open-close-of-newmark", "/stages/0/integration", "end of a step"},
        {"zero-joint-stiffness", "/joint_materials/smooth/normal_stiffness", "out of range"},
        {"negative-shear-stiffness", "/joint_materials/smooth/shear_stiffness", "out of range"},
        {"residual-over-peak", "/joint_materials/smooth/residual_friction_angle", "cannot increase"},
        {"rupture-interaction", "/bolt_types/mine/rupture_rule", "'steel'"},
        {"anchor-friction-angle", "/bolt_types/mine/anchors/0/friction_angle", "out of range"},
        {"zero-density", "/materials/rock/density", "out of range"},
        {"poisson-half", "/materials/rock/poissons_ratio", "out of range"},
        {"negative-modulus", "/materials/rock/youngs_modulus", "out of range"},
        {"friction-90", "/joint_materials/smooth/friction_angle", "out of range"},
        {"zero-thickness", "/analysis/thickness", "out of range"},
        {"no-divisions", "/bolts/0/divisions", "out of range"},
        {"too-many-divisions", "/bolts/0/divisions", "out of range"},
        {"no-frames", "/output/frames", "out of range"},
        {"zero-spacing", "/bolts/0/spacing_out_of_plane", "out of range"},
        {"far-away", "/blocks/1/points/1", "out of range"},
        {"two-corners", "/blocks/0/points", "2 corners"},
        {"no-corners", "/blocks/0/points", "0 corners"},
        {"zero-area", "/blocks/0/points", "no area"},
        {"self-crossing", "/blocks/0/points", "crosses itself"},
        {"closed-outline", "/blocks/0/points/4", "repeats the first"},
        {"repeated-corner", "/blocks/0/points/2", "repeats"},
        {"overlapping-blocks", "/blocks/1", "overlaps"},
        {"same-block-twice", "/blocks/2", "overlaps"},
        {"unknown-material", "/blocks/1/material", "'rock'"},
        {"unknown-joint-material", "/blocks/1/joint_material", "'smooth'"},
        {"duplicate-block-name", "/blocks/1/name", "already used"},
        {"support-nowhere", "/supports/0/block_at", "not in any block"},
        {"support-on-boundary", "/supports/0/block_at", "boundary"},
        {"support-without-place", "/supports/0", "exactly one"},
        {"point-support-off-block", "/supports/0/point", "not in any block"},
        {"point-support-all", "/supports/0/fix", "x, y or both"},
        {"unknown-bolt-type", "/bolts/0/type", "'rebar-20'"},
        {"cyclic-like", "/bolt_types/b/like", "in turn"},
        {"like-itself", "/bolt_types/a/like", "in turn"},
        {"unknown-like", "/bolt_types/a/like", "'d-bolt-20'"},
        {"no-steel", "/bolt_types/mine", "neither"},
        {"falling-steel", "/bolt_types/mine/steel/2", "decreases"},
        {"steepening-steel", "/bolt_types/mine/steel/2", "steeper"},
        {"steel-strain-back", "/bolt_types/mine/steel/2", "does not increase"},
        {"steel-off-origin", "/bolt_types/mine/steel", "[0, 0]"},
        {"modulus-against-steel", "/bolt_types/mine/youngs_modulus", "1 %"},
        {"area-over-circle", "/bolt_types/mine/area", "full circle"},
        {"plate-without-stiffness", "/bolt_types/mine/plate/normal_stiffness", "out of range"},
        {"peak-without-strength", "/bolt_types/mine/anchors/0/strength", "needs a strength"},
        {"residual-over-strength", "/bolt_types/mine/anchors/0/residual", "larger"},
        {"anchor-without-stiffness", "/bolt_types/mine/anchors/0/stiffness", "needs a stiffness"},
        {"anchor-without-law", "/bolt_types/mine/anchors/0/law", "no 'law'"},
        {"anchor-place-and-range", "/bolt_types/mine/anchors/0", "both"},
        {"anchor-range-backwards", "/bolt_types/mine/anchors/0/to", "ends at its start"},
        {"curve-without-points", "/bolt_types/mine/anchors/0/points", "[0, 0]"},
        {"residual-of-friction", "/bolt_types/mine/anchors/0/residual", "is allowed only"},
        {"bolt-outside", "/bolts/0", "any block"},
        {"bolt-without-length", "/bolts/0/head", "no length"},
        {"bolt-along-face", "/bolts/0", "lies along a face"},
        {"bolt-half-along-a-joint", "/bolts/0", "from 0.5 m to 1.25 m"},
        {"anchor-past-end", "/bolts/0/anchors/0/at", "past the end"},
        {"type-longer-than-bolt", "/bolts/0/type", "past the end"},
        {"duplicate-bolt-name", "/bolts/1/name", "already used"},
        {"two-motions-on-one-block", "/stages/0/motions/1/block_at", "already has a motion"},
        {"motion-on-fixed-block", "/stages/0/motions/0/block_at", "fixed by a support"},
        {"load-on-fixed-block", "/stages/0/loads/0/block_at", "fixed by a support"},
        {"motion-without-axis", "/stages/0/motions/0/axis", "no direction"},
        {"table-back-in-time", "/stages/0/motions/0/table/2", "does not increase"},
        {"empty-table", "/stages/0/motions/0/table", "no table"},
        {"duration-of-static", "/stages/0/duration", "'dynamic'"},
        {"increments-of-dynamic", "/stages/0/increments", "'static'"},
        {"dynamic-without-duration", "/stages/0/duration", "needs a duration"},
        {"load-without-place", "/stages/0/loads/0", "exactly one"},
        {"load-at-elsewhere", "/stages/0/loads/0/at", "outside the block"},
        {"pressure-on-no-edge", "/stages/0/loads/0/along", "no edge"},
        {"pressure-of-a-point", "/stages/0/loads/0/pressure", "'along'"},
        {"stages-without-blocks", "/blocks", "no blocks"},
        {"duplicate-stage-name", "/stages/1/name", "already used"},
        {"velocity-nowhere", "/stages/0/initial_velocities/0/block_at", "not in any block"},
        {"record-missing", "/stages/0/base_acceleration/file", "cannot be opened"},
        {"record-is-folder", "/stages/0/base_acceleration/file", "folder"},
        {"record-empty", "/stages/0/base_acceleration/file", "is empty"},
        {"record-header-only", "/stages/0/base_acceleration/file", "no rows"},
        {"record-one-row", "/stages/0/base_acceleration/file", "single row"},
        {"record-wrong-header", "/stages/0/base_acceleration/file", "'time_s,a'"},
        {"record-no-header", "/stages/0/base_acceleration/file", "'time_s,a'"},
        {"record-semicolons", "/stages/0/base_acceleration/file", "not semicolons"},
        {"record-decimal-commas", "/stages/0/base_acceleration/file", "row 3: the row has 4 columns"},
        {"record-semicolon-row", "/stages/0/base_acceleration/file", "row 3: the row has a semicolon"},
        {"record-times-back", "/stages/0/base_acceleration/file", "row 4, column 1: the time does not increase"},
        {"record-nan", "/stages/0/base_acceleration/file", "row 3, column 2"},
        {"record-unit", "/stages/0/base_acceleration/file", "row 3, column 2: '0.1g' is not a number"},
        {"record-negative-time", "/stages/0/base_acceleration/file", "row 2, column 1: the time is negative"},
        {"record-gap", "/stages/0/base_acceleration/file", "row 3: the row is empty"},
        {"record-quotes", "/stages/0/base_acceleration/file", "quotes"},
        {"record-utf-16", "/stages/0/base_acceleration/file", "UTF-16"},
        {"excavate-unknown", "/stages/0/excavate/0", "Did you mean 'right'?"},
        {"excavate-twice", "/stages/1/excavate/0", "already"},
        {"motion-of-excavated", "/stages/1/motions/0/block_at", "is excavated"},
        {"relaxation-beyond-all", "/stages/0/relaxation", "out of range"},
        {"install-unknown", "/stages/0/install/0", "there is no bolt"},
        {"bolt-named-as-pattern", "/bolts/0/name", "used by a bolt pattern (/bolt_patterns/0)"},
        {"pattern-named-as-bolt-of-another", "/bolt_patterns/0/name", "used by a bolt pattern (/bolt_patterns/1)"},
        {"block-named-as-tunnel", "/blocks/0/name", "used by a tunnel (/tunnels/0)"},
        {"install-twice", "/stages/1/install/0", "already"},
        {"remove-before-install", "/stages/0/remove/0", "not installed yet"},
        {"remove-twice", "/stages/1/remove/0", "already"},
        {"dilation-unknown", "/stages/0/dilations/0/joint", "Did you mean 'smooth'?"},
        {"dilation-unknown-joint", "/stages/0/dilations/0/joint", "Did you mean 'fault'?"},
        {"dilation-twice", "/stages/0/dilations/1/joint", "already opens"},
        {"viscous-of-static", "/stages/0/viscous_boundaries", "'dynamic'"},
        {"viscous-unknown-side", "/stages/0/viscous_boundaries/0", "Did you mean 'left'?"},
        {"viscous-side-without-face", "/stages/0/viscous_boundaries/0", "no block has a face"},
        {"acceleration-of-static", "/stages/0/body_acceleration/sine", "Give a constant 'value'"},
        {"acceleration-record-of-static", "/stages/0/body_acceleration/record", "Give a constant 'value'"},
        {"acceleration-of-nothing", "/stages/0/body_acceleration", "exactly one of"},
        {"acceleration-of-both", "/stages/0/body_acceleration", "Keep only one of them"},
        {"acceleration-of-value-and-sine", "/stages/0/body_acceleration", "Keep only one of them"},
        {"base-acceleration-of-static", "/stages/0/base_acceleration", "'dynamic'"},
        {"acceleration-without-axis", "/stages/0/body_acceleration/axis", "no 'axis'"},
        {"acceleration-axis-zero", "/stages/0/body_acceleration/axis", "no direction"},
        {"sine-negative-frequency", "/stages/0/body_acceleration/sine/frequency", "out of range"},
        {"sine-without-amplitude", "/stages/0/body_acceleration/sine/amplitude", "no 'amplitude'"},
        {"record-inside-times-back", "/stages/0/base_acceleration/record/2", "does not increase"},
        {"set-unknown-joint-material", "/stages/0/set/0/joint_material", "'smooth'"},
        {"set-nothing", "/stages/0/set/0", "changes nothing"},
        {"set-twice", "/stages/0/set/1/joint_material", "already changed"},
        {"set-residual-over-peak", "/stages/1/set/0/residual_friction_angle", "cannot increase from 20° to 25°"},
        {"set-friction-90", "/stages/0/set/0/friction_angle", "out of range"},
        {"limit-no-steps", "/limits/steps", "out of range"},
        {"limit-no-time", "/limits/wall_time", "out of range"},
        {"limit-no-energy", "/limits/energy", "out of range"},
        {"monitor-of-unknown-bolt", "/monitors/1/bolt", "'C'"},
        {"monitor-past-end", "/monitors/1/at", "beyond the end"},
        {"monitor-of-nothing", "/monitors/1", "exactly one"},
        {"monitor-of-two-things", "/monitors/0", "exactly one"},
        {"between-in-the-air", "/monitors/0/between/1", "not in any block"},
        {"monitor-two-places", "/monitors/1", "more than one position"},
        {"duplicate-monitor-name", "/monitors/1/name", "already used"},
        {"unknown-quantity", "/quantities/0", "forse"},
        {"unknown-event-kind", "/quantities/0", "bang"},
        {"unknown-expected", "/about/expected/0/quantity", "mean"},
        {"domain-two-corners", "/domain/boundary", "at least three"},
        {"domain-crosses-itself", "/domain/boundary", "crosses itself"},
        {"domain-unknown-material", "/domain/material", "rock"},
        {"domain-unknown-joint-material", "/domain/joint_material", "rough"},
        {"domain-overlaps-block", "/blocks/0", "overlaps the domain"},
        {"cutting-too-coarse", "/cutting/tolerance", "hundredth"},
        {"joint-without-domain", "/joints/0", "no domain"},
        {"joint-of-one-point", "/joints/0/points", "two or more"},
        {"joint-unknown-material", "/joints/0/joint_material", "rough"},
        {"joint-set-too-fine", "/joint_sets/0/spacing", "traces"},
        {"joint-set-unknown-region", "/joint_sets/0/region", "roof"},
        {"joint-set-scatter", "/joint_sets/0/spacing_deviation", "twice the mean"},
        {"joint-set-bridge-alone", "/joint_sets/0/bridge", "trace_length"},
        {"joint-sets-cross-too-often", "/domain", "crossings"},
        {"duplicate-tunnel-name", "/tunnels/1/name", "already used"},
        {"voronoi-too-small", "/voronoi/size", "cells"},
        {"voronoi-unknown-region", "/voronoi/region", "roof"},
        {"region-repeats-corner", "/regions/0/points/3", "repeats"},
        {"tunnel-without-profile", "/tunnels/0/profile", "profile"},
        {"tunnel-unknown-profile", "/tunnels/0/profile", "circle"},
        {"tunnel-too-low", "/tunnels/0/height", "half the width"},
        {"tunnel-diameter-of-d-shape", "/tunnels/0/diameter", "circle"},
        {"pattern-unknown-tunnel", "/bolt_patterns/0/tunnel", "drift"},
        {"pattern-unknown-type", "/bolt_patterns/0/type", "rebar-20"},
        {"pattern-too-flat", "/bolt_patterns/0/angle_from_wall", "10"},
        {"pattern-too-many", "/bolt_patterns/0/spacing", "bolts"},
        {"pattern-takes-bolt-name", "/bolt_patterns/0/name", "already used"},
        {"support-on-no-domain", "/supports/0/boundary", "no domain"},
        {"support-unknown-side", "/supports/0/boundary", "left"},
        {"monitor-in-open-tunnel", "/monitors/0/point", "not in any block"},
    };
    return scenes;
}

class BrokenSceneTest : public testing::TestWithParam<BrokenScene> {};

TEST_P(BrokenSceneTest, IsRefusedOnceAtItsPlace) {
    const BrokenScene& expected = GetParam();
    const SceneReading reading = readSceneFile(folder / (expected.file + ".json"));
    EXPECT_FALSE(reading.scene);
    const auto errors = std::count_if(reading.problems.begin(), reading.problems.end(),
                                      [](const Problem& problem) { return problem.severity == Severity::Error; });
    ASSERT_EQ(errors, 1) << test::problemList(reading.problems);
    const auto error = std::find_if(reading.problems.begin(), reading.problems.end(),
                                    [](const Problem& problem) { return problem.severity == Severity::Error; });
    EXPECT_EQ(error->pointer, expected.pointer) << test::problemList(reading.problems);
    EXPECT_NE((error->message + error->remedy).find(expected.word), std::string::npos) << test::problemList(reading.problems);
    EXPECT_GE(error->line, 1);
    EXPECT_FALSE(error->remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenSceneTest, testing::ValuesIn(brokenScenes()), [](const auto& scene) {
    std::string name = scene.param.file;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(BrokenScenes, AreAllListedHere) {
    std::set<std::string> listed;
    for (const BrokenScene& scene : brokenScenes())
        listed.insert(scene.file);
    std::set<std::string> present;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        present.insert(entry.path().stem().string());
    EXPECT_EQ(listed, present);
}

// Texts too large to keep as files; each must be refused at its limit.
class HostileText : public testing::Test {
protected:
    void expectRefused(const std::string& text, const std::string& word) {
        const SceneReading reading = readSceneText(text, "hostile");
        EXPECT_FALSE(reading.scene);
        ASSERT_FALSE(reading.problems.empty());
        EXPECT_NE(reading.problems.front().message.find(word), std::string::npos) << reading.problems.front().message;
    }
};

TEST_F(HostileText, HundredMegabytesOfBrackets) { expectRefused(std::string(100'000'000, '['), "longer than"); }

TEST_F(HostileText, BracketsWithinTheLimitOfLength) { expectRefused(std::string(60'000'000, '['), "deep"); }

TEST_F(HostileText, ObjectsInsideObjects) {
    std::string text;
    for (int i = 0; i < 100'000; ++i)
        text += "{\"a\":";
    expectRefused(text, "deep");
}

TEST_F(HostileText, MillionsOfValues) {
    std::string text = "[0";
    for (int i = 0; i < 2'100'000; ++i)
        text += ",0";
    expectRefused(text + "]", "more than 2000000 values");
}

TEST_F(HostileText, ManyUnknownKeys) {
    std::string text = "{\"format\": \"keyblock-scene\", \"version\": 1";
    for (int i = 0; i < 200'000; ++i) text += ",\"gravity" + std::to_string(i) + "\":0";
    const std::clock_t start = std::clock();
    expectRefused(text + "}", "has no key");
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10.0);
}

TEST_F(HostileText, NumberOfAMillionDigits) {
    expectRefused("{\"version\": " + std::string(1'000'000, '9') + "}", "overflow");
}

TEST_F(HostileText, ZeroBytes) { expectRefused(std::string(1000, '\0'), "not valid JSON"); }

TEST_F(HostileText, ChainOfTypesThatAreLikeOneAnother) {
    std::string types;
    for (int i = 20'000; i > 0; --i)
        types += "\"t" + std::to_string(i) + "\": {\"like\": \"t" + std::to_string(i - 1) + "\"},\n";
    types += "\"t0\": {\"youngs_modulus\": 2e11}";
    expectRefused("{\"format\": \"keyblock-scene\", \"version\": 1, \"bolt_types\": {" + types + "}}", "in a chain");
}

TEST(ManyProblems, AreCutOffWithAWord) {
    std::string blocks;
    for (int i = 0; i < 5000; ++i)
        blocks += std::string(i == 0 ? "" : ",\n") + "{}";
    const SceneReading reading =
        readSceneText("{\"format\": \"keyblock-scene\", \"version\": 1, \"blocks\": [" + blocks + "]}", "many");
    EXPECT_EQ(reading.problems.size(), mostProblems);
    EXPECT_NE(reading.problems.back().message.find("more problems"), std::string::npos);
}

TEST(SceneFiles, ThatCannotBeReadAreProblems) {
    const SceneReading missing = readSceneFile(folder / "there-is-no-such-file.json");
    ASSERT_EQ(missing.problems.size(), 1u);
    EXPECT_NE(missing.problems[0].message.find("cannot be opened"), std::string::npos);
    const SceneReading directory = readSceneFile(folder);
    ASSERT_EQ(directory.problems.size(), 1u);
    EXPECT_NE(directory.problems[0].message.find("folder"), std::string::npos);
}

}  // namespace
}  // namespace keyblock
