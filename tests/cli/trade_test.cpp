// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `trade`: its files, its answer, and refusals.
#include "tests/cli/command_line_fixture.h"

namespace keyblock::test {
namespace {

class TradeCommand : public CommandLine {};

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

}  // namespace
}  // namespace keyblock::test
