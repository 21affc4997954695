// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes that are wrong, files that are something else, places that cannot be
// written: each with its code and a line that says what to do.
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

namespace keyblock::test {
namespace {

class Files : public CommandLine {
protected:
    void expectError(const std::vector<std::string>& words, int code, const std::string& part) const {
        const Ended ended = keyblock(words);
        EXPECT_EQ(ended.code, code) << words.front() << ": " << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    }
};

TEST_F(Files, AWrongSceneIsReportedAndNotRun) {
    putPullScene();
    std::string text = content("pull.json");
    text.replace(text.find("\"youngs_modulus\": 60e9"), 22, "\"youngs_modulus\": -1");
    put("wrong.json", text);
    expectError({"run", "wrong.json"}, 3, "/materials/rock/youngs_modulus");
    EXPECT_FALSE(exists("wrong.kbrun"));
    expectError({"check", "wrong.json"}, 3, "/materials/rock/youngs_modulus");
    expectError({"run", "missing.json"}, 3, "missing.json");
}

TEST_F(Files, ASceneWithoutStagesIsCheckedButNotRun) {
    putEndlessScene();
    std::string text = content("rest.json");
    const auto start = text.find("  \"stages\"");
    text.erase(start, text.find("  \"monitors\"") - start);
    put("still.json", text);
    EXPECT_EQ(keyblock({"check", "still.json"}).code, 0);
    expectError({"run", "still.json"}, 3, "no stages");
    EXPECT_FALSE(exists("still.kbrun"));
}

TEST_F(Files, CheckAnswersInJson) {
    putPullScene();
    EXPECT_TRUE(nlohmann::json::parse(keyblock({"check", "pull.json", "--json"}).out).at("problems").is_array());
    const Ended wrong = keyblock({"check", "pull.json", "--json", "--set", "materials.rock.density=-5"});
    EXPECT_EQ(wrong.code, 3);
    const nlohmann::json problem = nlohmann::json::parse(wrong.out).at("problems").at(0);
    EXPECT_EQ(problem.at("severity"), "error");
    EXPECT_EQ(problem.at("pointer"), "/materials/rock/density");
    EXPECT_TRUE(problem.contains("line"));
    EXPECT_FALSE(problem.at("message").get<std::string>().empty());
    EXPECT_FALSE(problem.at("remedy").get<std::string>().empty());
}

TEST_F(Files, CheckTellsWhatIsModelledOfASoundScene) {
    putPullScene();
    const nlohmann::json census =
        nlohmann::json::parse(keyblock({"check", "pull.json", "--json"}).out).at("census");
    EXPECT_EQ(census.at("blocks"), 2);
    EXPECT_EQ(census.at("fixed"), 1);
    EXPECT_EQ(census.at("contacts"), 2);
    EXPECT_EQ(census.at("unknowns").at("blocks"), 6);
    EXPECT_EQ(census.at("unknowns").at("bolts"), 3 * census.at("nodes").get<int>());
    for (const nlohmann::json& part : census.at("left_out"))
        for (const char* key : {"what", "why", "saves"})
            EXPECT_FALSE(part.at(key).get<std::string>().empty());
    EXPECT_GT(census.at("estimate").at("seconds"), 0.0);
    EXPECT_GT(census.at("estimate").at("memory_MB"), 0.0);
    const std::string text = keyblock({"check", "pull.json"}).out;
    for (const char* part : {"modelled: ", "2 blocks (1 fixed), 6 unknowns", "left out:", "a run may take "})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    const Ended wrong = keyblock({"check", "pull.json", "--json", "--set", "materials.rock.density=-5"});
    EXPECT_FALSE(nlohmann::json::parse(wrong.out).contains("census"));
}

TEST_F(Files, WhatIsNoRunStoreIsRefused) {
    putPullScene();
    put("empty.kbrun", "");
    expectError({"info", "pull.json"}, 3, "not a run store");
    expectError({"info", "empty.kbrun"}, 3, "empty");
    expectError({"info", "missing.kbrun"}, 3, "no such file");
    expectError({"export", "pull.json", "--table", "events", "--out", "t.csv"}, 3, "not a run store");
    EXPECT_FALSE(exists("t.csv"));
}

TEST_F(Files, PlacesThatCannotBeWrittenAreReported) {
    putPullScene();
    expectError({"run", "pull.json", "--out", "missing/run.kbrun"}, 6, "missing/run.kbrun");
    ASSERT_EQ(keyblock({"run", "pull.json"}).code, 0);
    expectError({"export", "pull.kbrun", "--table", "events", "--out", "missing/t.csv"}, 6, "missing/t.csv");
    expectError({"export", "pull.kbrun", "--table", "events", "--out", "/dev/full"}, 6, "No space left");
}

TEST_F(Files, AStoreIsReplacedOnlyWhenAsked) {
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json"}).code, 0);
    const std::string before = content("pull.kbrun");
    expectError({"run", "pull.json"}, 2, "--overwrite");
    EXPECT_EQ(content("pull.kbrun"), before);
    EXPECT_EQ(keyblock({"run", "pull.json", "--overwrite"}).code, 0);
    expectError({"run", "pull.json", "--out", "pull.json", "--overwrite"}, 2, "not a run store");
}

}  // namespace
}  // namespace keyblock::test
