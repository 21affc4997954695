// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Presets and estimated errors on the command line.
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

namespace keyblock::test {
namespace {

class PresetCommands : public CommandLine {
protected:
    nlohmann::json info(const std::string& run) { return nlohmann::json::parse(keyblock({"info", run, "--json"}).out); }
};

TEST_F(PresetCommands, CheckListsWhereSettingsComeFrom) {
    putPullScene();
    const Ended ended = keyblock({"check", "pull.json", "--preset", "sketch", "--set", "analysis.max_passes=50"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("preset sketch, 1 setting changed"), std::string::npos) << ended.out;
    const auto json = nlohmann::json::parse(
        keyblock({"check", "pull.json", "--json", "--preset", "sketch", "--set", "analysis/max_passes=50"}).out);
    EXPECT_EQ(json["preset"]["name"], "sketch");
    for (const auto& setting : json["preset"]["settings"])
        EXPECT_EQ(setting["from"], setting["key"] == "max_passes" ? "--set" : "preset") << setting;
}

TEST_F(PresetCommands, ARunNamesItsPresetAndSketchWarns) {
    putPullScene();
    const Ended draft = keyblock({"run", "pull.json", "--preset", "draft"});
    ASSERT_EQ(draft.code, 0) << draft.err;
    EXPECT_NE(draft.out.find("preset  draft\n"), std::string::npos) << draft.out;
    EXPECT_EQ(draft.out.find("warning: made with"), std::string::npos) << draft.out;
    EXPECT_EQ(info("pull.kbrun")["preset"], "draft");
    const Ended sketch = keyblock({"run", "pull.json", "--preset", "sketch", "--overwrite"});
    EXPECT_NE(sketch.out.find("warning: made with the preset sketch"), std::string::npos) << sketch.out;
    EXPECT_EQ(info("pull.kbrun")["warnings"][0]["stage"], nullptr);
}

TEST_F(PresetCommands, PresetReplacesThatOfTheSceneAndItsValuesStay) {
    putPullScene();
    const Ended ended = keyblock({"check", "pull.json", "--json", "--set", "analysis.preset=reference",
                                  "analysis.tolerance=1e-7", "--preset", "draft"});
    const auto preset = nlohmann::json::parse(ended.out)["preset"];
    EXPECT_EQ(preset["text"], "reference, 1 setting changed") << "--set goes before --preset";
}

TEST_F(PresetCommands, AnUnknownPresetIsAUsageError) {
    putPullScene();
    const Ended ended = keyblock({"run", "pull.json", "--preset", "fast"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("sketch|draft|engineering|reference"), std::string::npos) << ended.err;
    EXPECT_EQ(keyblock({"check", "pull.json", "--set", "analysis.preset=fast"}).code, 3);
}

TEST_F(PresetCommands, EstimatedErrorsArePrintedAndKept) {
    putPullScene();
    EXPECT_EQ(keyblock({"run", "pull.json"}).code, 0);
    EXPECT_EQ(info("pull.kbrun")["estimated_errors"], nullptr);
    const Ended ended = keyblock({"run", "pull.json", "--resume", "--estimate-error"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("estimated errors"), std::string::npos) << ended.out;
    const auto estimate = info("pull.kbrun")["estimated_errors"];
    ASSERT_TRUE(estimate.is_object());
    EXPECT_FALSE(estimate["refinements"].empty());
    ASSERT_FALSE(estimate["quantities"].empty());
    EXPECT_NE(keyblock({"info", "pull.kbrun"}).out.find("estimated errors"), std::string::npos);
}

}  // namespace
}  // namespace keyblock::test
