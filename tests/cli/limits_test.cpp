// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs that do not come to their end: each with its exit code, and with what it
// had found.
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace keyblock::test {
namespace {

using nlohmann::json;

class EarlyEnds : public CommandLine {
protected:
    json info(const std::string& run) const {
        const Ended ended = keyblock({"info", run, "--json"});
        EXPECT_EQ(ended.code, 0) << ended.err;
        return json::parse(ended.out);
    }
};

TEST_F(EarlyEnds, ALimitOfStepsIsExitCodeFive) {
    putEndlessScene();
    const Ended ended = keyblock({"run", "rest.json", "--set", "limits.steps=50"});
    EXPECT_EQ(ended.code, 5) << ended.err;
    EXPECT_NE(ended.err.find("a limit was reached; results so far are in rest.kbrun"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("the limit of 50 steps"), std::string::npos) << ended.out;
    EXPECT_EQ(info("rest.kbrun").at("stages").at(0).at("outcome"), "limit");
    EXPECT_EQ(info("rest.kbrun").at("stages").at(0).at("steps"), 50);
    EXPECT_GT(lines(table("rest.kbrun", "history")).size(), 2U);
}

/// The clock decides when a run ends, and nothing else: its rows are the first of those of a longer run.
TEST_F(EarlyEnds, ALimitOfTimeIsExitCodeFiveAndChangesNoByte) {
    putEndlessScene();
    ASSERT_EQ(keyblock({"run", "rest.json", "--set", "limits.wall_time=1", "--out", "short.kbrun"}).code, 5);
    ASSERT_EQ(keyblock({"run", "rest.json", "--set", "limits.wall_time=2", "--out", "long.kbrun"}).code, 5);
    const auto shorter = lines(table("short.kbrun", "history")), longer = lines(table("long.kbrun", "history"));
    ASSERT_GT(shorter.size(), 1U);
    for (std::size_t i = 0; i + 1 < std::min(shorter.size(), longer.size()); ++i) EXPECT_EQ(shorter[i], longer[i]) << i;
}

TEST_F(EarlyEnds, ANumericalFailureIsExitCodeFourAndKeepsItsResults) {
    putEndlessScene();
    const Ended ended = keyblock({"run", "rest.json", "--set", "analysis.max_passes=1", "analysis.tolerance=1e-15",
                                  "stages[0].initial_velocities=[{\"block_at\": [1.5, 1.5], \"velocity\": [0, -10]}]"});
    EXPECT_EQ(ended.code, 4) << ended.err << ended.out;
    EXPECT_NE(ended.err.find("stage 'rest'"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("results so far are in rest.kbrun"), std::string::npos) << ended.err;
    EXPECT_EQ(info("rest.kbrun").at("stages").at(0).at("outcome"), "failed");
    EXPECT_GT(lines(table("rest.kbrun", "blocks")).size(), 1U);
}

/// A collapse is a result.
TEST_F(EarlyEnds, ACollapseIsExitCodeZero) {
    putEndlessScene();
    const Ended ended = keyblock({"run", "rest.json", "--set", "supports=[]",
                                  "stages=[{\"name\": \"fall\"}, {\"name\": \"on\"}]"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(info("rest.kbrun").at("stages").at(0).at("outcome"), "collapse");
}

/// On request the exit code says that the scene is not stable.
TEST_F(EarlyEnds, ACollapseIsExitCodeEightWhereItIsAskedFor) {
    putEndlessScene();
    const std::vector<std::string> words{"run", "rest.json", "--fail-on-collapse", "--set", "supports=[]",
                                         "stages=[{\"name\": \"fall\"}]"};
    const Ended ended = keyblock(words);
    EXPECT_EQ(ended.code, 8) << ended.err;
    EXPECT_NE(ended.out.find("stable  NO"), std::string::npos) << ended.out;
    const json verdict = info("rest.kbrun").at("verdict");
    EXPECT_EQ(verdict.at("stands"), false);
    for (const json& block : verdict.at("blocks")) {
        EXPECT_EQ(block.at("mode"), "falls");
        EXPECT_GT(block.at("moved_m"), 0.0);
        EXPECT_GT(block.at("weight_N"), 0.0);
    }
    EXPECT_FALSE(verdict.at("blocks").empty());
}

TEST_F(EarlyEnds, WhatStandsIsExitCodeZeroWhoeverAsks) {
    putEndlessScene();
    const Ended ended = keyblock({"run", "rest.json", "--fail-on-collapse", "--set", "stages=[{\"name\": \"rest\"}]"});
    EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
    EXPECT_NE(ended.out.find("stable  yes"), std::string::npos) << ended.out;
    const json answer = info("rest.kbrun");
    EXPECT_EQ(answer.at("verdict").at("stands"), true);
    EXPECT_LE(answer.at("worst_balance").at("ratio"), 1e-3);
}

/// A search that is cut short has no verdict.
TEST_F(EarlyEnds, NoVerdictIsExitCodeFive) {
    putEndlessScene();
    const Ended ended = keyblock({"run", "rest.json", "--set", "supports=[]", "stages=[{\"name\": \"fall\"}]",
                                  "limits.iterations=2"});
    EXPECT_EQ(ended.code, 5) << ended.err;
    EXPECT_EQ(info("rest.kbrun").at("stages").at(0).at("outcome"), "undecided");
    EXPECT_EQ(info("rest.kbrun").at("verdict").at("stands"), nullptr);
}

/// With little memory a run ends, right or with a message, and does not wait for more.
TEST_F(EarlyEnds, AnAddressSpaceThatIsTooSmallEndsInWords) {
    if (std::getenv("ASAN_OPTIONS")) GTEST_SKIP() << "the address sanitizer needs a larger one";
    put("rest.json", contentOf(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json"));  // its matrices need OpenBLAS
    int right = 0;
    for (const std::size_t megabytes : {150, 220, 280, 400}) {
        Program program({"run", "rest.json", "--overwrite", "--set", "limits.steps=1"}, folder(), {}, megabytes << 20);
        const Ended ended = program.wait();
        right += ended.code == 5;
        EXPECT_TRUE(ended.code == 5 || !ended.err.empty()) << megabytes << " MB";
        EXPECT_EQ(ended.err.find("internal"), std::string::npos) << ended.err;
    }
    EXPECT_GT(right, 0);
}

class Records : public EarlyEnds {
protected:
    void putShakenScene(const std::string& record) const {
        putEndlessScene();
        put("motion.csv", record);
    }
    static std::vector<std::string> shaken(const std::string& verb, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{verb, "rest.json", "--set", "stages[0].duration=0.1",
                                       "stages[0].base_acceleration={\"file\": \"motion.csv\", \"axis\": \"x\"}"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
};

TEST_F(Records, StayInTheStoreWithTheirScene) {
    putShakenScene("time_s,a\n0,0\n0.05,1\n0.1,0\n");
    const Ended ended = keyblock(shaken("run"));
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("integrated from rest"), std::string::npos) << ended.out;
    const std::string hash = info("rest.kbrun").at("scene_hash");
    put("motion.csv", "time_s,a\n0,0\n0.05,2\n0.1,0\n");
    EXPECT_EQ(info("rest.kbrun").at("scene_hash"), hash);
    ASSERT_EQ(keyblock(shaken("run", {"--overwrite"})).code, 0);
    EXPECT_NE(info("rest.kbrun").at("scene_hash"), hash);
    std::filesystem::remove(folder() / "motion.csv");
    EXPECT_GT(lines(table("rest.kbrun", "history")).size(), 2U);
}

TEST_F(Records, ThatAreWrongAreReportedWithRowAndColumn) {
    putShakenScene("time_s,a\n0,0\n0.05,x\n0.1,y\n");
    const Ended ended = keyblock(shaken("check"));
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.err.find("motion.csv: row 3, column 2: 'x' is not a number"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("motion.csv: row 4, column 2: 'y' is not a number"), std::string::npos) << ended.err;
    EXPECT_EQ(keyblock(shaken("run")).code, 3);
    EXPECT_FALSE(exists("rest.kbrun"));
}

}  // namespace
}  // namespace keyblock::test
