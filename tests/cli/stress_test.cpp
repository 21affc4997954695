// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands `stress` and `verify --extremes`: their answers, exit codes and refusals.
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

namespace keyblock::test {
namespace {

class StressCommand : public CommandLine {};

constexpr const char* box = R"({"format": "keyblock-scene", "version": 1, "analysis": {"gravity": [0, -9.81]},
"materials": {"rock": {"density": 2700, "youngs_modulus": 1e10, "poissons_ratio": 0.2}},
"joint_materials": {"joint": {"friction_angle": 30}},
"blocks": [{"name": "slab", "points": [[-2, -1], [3, -1], [3, 0], [-2, 0]], "material": "rock"},
           {"name": "box", "points": [[0, 0], [1, 0], [1, 1], [0, 1]], "material": "rock"}],
"supports": [{"block_at": [0, -0.5], "fix": "all"}],
"stages": [{"name": "load", "loads": [{"block_at": [0.5, 0.5], "force": [10000, 0]}]}],
"monitors": [{"name": "top", "point": [0.5, 1]}], "quantities": ["stands", "max top.ux"]})";

TEST_F(StressCommand, NamesWhatBreaksFirst) {
    put("box.json", box);
    const Ended ended = keyblock({"stress", "box.json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("Breaks first: penalty ratio"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("What to set: "), std::string::npos);
}

TEST_F(StressCommand, AnswersInJson) {
    put("box.json", box);
    const Ended ended = keyblock({"stress", "box.json", "--json", "--set", "stages[0].loads[0].force=[7000,0]"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    const nlohmann::json answer = nlohmann::json::parse(ended.out);
    EXPECT_EQ(answer["quantities"].size(), 2u);
    EXPECT_FALSE(answer["interrupted"].get<bool>());
    bool tooMuch = false;  // 14 kN are 0.53 of the weight, less than tan 30°; 70 kN are more
    for (const auto& push : answer["pushes"]) {
        if (push["axis"] == "load" && push["push"] == "× 2") {
            EXPECT_NE(push["ending"], "verdict");
        }
        if (push["axis"] == "load" && push["push"] == "× 10") tooMuch = push["ending"] == "verdict";
        if (push["axis"] == "coordinates" && push["push"] == "+ 1e+04 m") {
            EXPECT_EQ(push["ending"], "same");
        }
    }
    EXPECT_TRUE(tooMuch) << ended.out;
}

TEST_F(StressCommand, RefusesASceneThatCannotRun) {
    put("broken.json", "{}");
    EXPECT_EQ(keyblock({"stress", "broken.json"}).code, 3);
    EXPECT_EQ(keyblock({"stress"}).code, 2);
}

class ExtremesCommand : public CommandLine {};

TEST_F(ExtremesCommand, RunsACaseWritesThePageAndAnswersInJson) {
    const Ended ended = keyblock(
        {"verify", "--extremes", "--case", "box/penalty", "--random", "5", "--page", "limits.md"});
    EXPECT_EQ(ended.code, 0) << ended.out;
    EXPECT_NE(ended.out.find("0 wrong"), std::string::npos) << ended.out;
    EXPECT_NE(content("limits.md").find("## Penalty ratio"), std::string::npos);
    const nlohmann::json answer = nlohmann::json::parse(
        keyblock({"verify", "--extremes", "--random", "3", "--seed", "5", "--json"}).out);
    EXPECT_EQ(answer["random"][0]["runs"].size(), 3u);
    EXPECT_EQ(answer["counts"]["wrong"], 0);
}

TEST_F(ExtremesCommand, NamesTheCasesForAnUnknownOne) {
    const Ended ended = keyblock({"verify", "--extremes", "--case", "missing"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("box/penalty"), std::string::npos);
    EXPECT_EQ(keyblock({"verify", "--random", "3"}).code, 2);
    EXPECT_EQ(keyblock({"verify", "--extremes", "--paper"}).code, 2);
}

}  // namespace
}  // namespace keyblock::test
