// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `trade`: its files, its answer, refusals, interruptions and full disks.
#include "tests/cli/command_line_fixture.h"
#include "tests/wait_for.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <csignal>

namespace keyblock::test {
namespace {

class TradeCommand : public CommandLine {
protected:
    std::size_t pointsIn(const std::string& trade) const {
        if (!exists(trade + "/points.json")) return 0;
        return nlohmann::json::parse(content(trade + "/points.json")).at("points").size();
    }

    /// Axis, setting, quantity, value and error of each row; times differ from run to run.
    std::vector<std::string> results(const std::string& trade) const {
        std::vector<std::string> rows;
        for (const std::string& line : lines(content(trade + "/trade.csv"))) {
            std::size_t end = 0;
            for (int commas = 0; end < line.size() && commas < 5; ++end) commas += line[end] == ',' ? 1 : 0;
            rows.push_back(line.substr(0, end));
        }
        return rows;
    }
};

TEST_F(TradeCommand, WritesATableAPageAndAChartAndRecommends) {
    putPullScene();
    const Ended ended = keyblock({"trade", "pull.json", "--out", "traded", "--budget", "4"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("own settings"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("of the finest run"), std::string::npos) << ended.out;
    const std::vector<std::string> table = lines(content("traded/trade.csv"));
    ASSERT_GT(table.size(), 2u);
    EXPECT_TRUE(table[1].starts_with("own settings,,")) << table[1];
    EXPECT_NE(content("traded/trade.md").find("# Accuracy and time"), std::string::npos);
#ifdef KEYBLOCK_HAS_FIGURES
    EXPECT_NE(content("traded/trade.svg").find("Largest error"), std::string::npos);
#else
    EXPECT_NE(ended.out.find("built without figures"), std::string::npos) << ended.out;
#endif
}

TEST_F(TradeCommand, RefusesAFolderWithOtherFiles) {
    putPullScene();
    std::filesystem::create_directory(folder() / "full");
    put("full/notes.txt", "mine");
    const Ended ended = keyblock({"trade", "pull.json", "--out", "full"});
    EXPECT_EQ(ended.code, 6);
    EXPECT_NE(ended.err.find("notes.txt"), std::string::npos) << ended.err;
    EXPECT_EQ(content("full/notes.txt"), "mine");
}

TEST_F(TradeCommand, RefusesASceneThatCannotRun) {
    put("broken.json", "{}");
    EXPECT_EQ(keyblock({"trade", "broken.json", "--out", "traded"}).code, 3);
    EXPECT_FALSE(exists("traded"));
    EXPECT_EQ(keyblock({"trade", "broken.json"}).code, 2);
}

/// A trade that was stopped keeps its runs, does not repeat them, and ends with the results of one that was not.
TEST_F(TradeCommand, ContinuesWhereItWasInterrupted) {
    putPullScene();
    Program program({"trade", "pull.json", "--out", "stopped"}, folder());
    ASSERT_TRUE(waitFor([&] { return pointsIn("stopped") >= 3; }));
    program.signal(SIGINT);
    const Ended stopped = program.wait();
    EXPECT_EQ(stopped.code, 75) << stopped.err;
    EXPECT_NE(stopped.err.find("run again with the same --out to continue"), std::string::npos) << stopped.err;
    const std::size_t kept = pointsIn("stopped");
    EXPECT_NE(content("stopped/trade.md").find("interrupted"), std::string::npos);
    const Ended rest = keyblock({"trade", "pull.json", "--out", "stopped"});
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(rest.out.rfind(std::to_string(kept) + " runs of this trade are in stopped already", 0), 0u) << rest.out;
    EXPECT_EQ(content("stopped/trade.md").find("interrupted"), std::string::npos);
    ASSERT_EQ(keyblock({"trade", "pull.json", "--out", "whole"}).code, 0);
    std::vector<std::string> continued = results("stopped"), whole = results("whole");
    const auto withoutCombinations = [](std::vector<std::string>& rows) {
        std::erase_if(rows, [](const std::string& row) { return row.starts_with("combination"); });  // chosen by time
    };
    withoutCombinations(continued);
    withoutCombinations(whole);
    EXPECT_EQ(continued, whole);
}

TEST_F(TradeCommand, ReportsAFullDiskAndKeepsTheRunsMadeSoFar) {
    putPullScene();
    rlimit usual{};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    rlimit small = usual;
    small.rlim_cur = 4000;  // stands in for the disk; the program inherits it
    ::setrlimit(RLIMIT_FSIZE, &small);
    const Ended full = keyblock({"trade", "pull.json", "--out", "traded"});
    ::setrlimit(RLIMIT_FSIZE, &usual);
    EXPECT_EQ(full.code, 6) << full.err;
    EXPECT_EQ(full.err.rfind("error: cannot write ", 0), 0u) << full.err;
    EXPECT_GT(pointsIn("traded"), 0u);
    const Ended rest = keyblock({"trade", "pull.json", "--out", "traded", "--budget", "0.001"});
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_NE(rest.out.find("runs of this trade are in traded already"), std::string::npos) << rest.out;
}

TEST_F(TradeCommand, ReportsAFolderThatCannotBeWritten) {
    putPullScene();
    for (const std::string place : {"/proc/no-such-place/traded", "pull.json/traded"}) {
        const Ended ended = keyblock({"trade", "pull.json", "--out", place});
        EXPECT_EQ(ended.code, 6) << ended.err;
        EXPECT_EQ(ended.err.rfind("error: cannot write " + place, 0), 0u) << ended.err;
        EXPECT_EQ(lines(ended.err).size(), 1u) << ended.err;
    }
}

/// What `trade` has measured is what `check` proposes.
TEST_F(TradeCommand, GivesCheckWhatCouldBeLeftOutNext) {
    putPullScene();
    const auto next = [&] {
        return nlohmann::json::parse(keyblock({"check", "pull.json", "--json"}).out).at("census").at("next");
    };
    for (const auto& one : next()) EXPECT_EQ(one.at("measured"), false) << one;
    ASSERT_EQ(keyblock({"trade", "pull.json", "--out", "traded", "--budget", "1"}).code, 0);
    for (const auto& one : next())
        if (one.at("setting") == "divisions") {
            EXPECT_EQ(one.at("measured"), true) << one;
            EXPECT_NE(one.at("costs").get<std::string>().find("measured by 'trade'"), std::string::npos) << one;
        }
}

}  // namespace
}  // namespace keyblock::test
