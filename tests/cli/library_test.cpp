// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolt library and the verification suite as a user at a terminal sees them.
#include "tests/cli/command_line_fixture.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

namespace keyblock::test {
namespace {

using Library = CommandLine;
using nlohmann::json;

TEST_F(Library, ListsEveryType) {
    const Ended ended = keyblock({"bolts"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    for (const std::string name : {"rebar-20", "rebar-20-paper", "split-set-47", "swellex-12t", "expansion-shell-17",
                                   "d-bolt-20", "cone-bolt-17", "roofex-rx8", "garford-20"})
        EXPECT_NE(ended.out.find("\n" + name + " "), std::string::npos) << name;
}

TEST_F(Library, GivesEveryNumberWithItsSource) {
    const Ended ended = keyblock({"bolts", "rebar-20-paper"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("diameter"), std::string::npos);
    EXPECT_NE(ended.out.find("24560"), std::string::npos) << ended.out;
}

TEST_F(Library, MarksWhatNoSourceConfirms) {
    EXPECT_NE(keyblock({"bolts", "split-set-47"}).out.find("?"), std::string::npos);
}

TEST_F(Library, OneCaseOfTheSuiteAnswersInJson) {
    const Ended ended = keyblock({"verify", "--case", "free fall", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    const json cases = json::parse(ended.out).at("cases");
    ASSERT_FALSE(cases.empty());
    for (const json& one : cases) {
        EXPECT_EQ(one.at("name"), "free fall");
        EXPECT_TRUE(one.at("passed").get<bool>());
        for (const char* key : {"measured", "expected", "tolerance", "seconds"})
            EXPECT_TRUE(one.at(key).is_number()) << key;
    }
}

TEST_F(Library, AReaderThatWentAwayIsNoError) {
    // The reader leaves first; the program must neither die of a signal nor complain.
    const std::string command = "cd " + folder().string() + " && { sleep 0.3; " + KEYBLOCK_PROGRAM +
                                " bolts; echo $? > code; } 2> err | true";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(content("code"), "0\n");
    EXPECT_EQ(content("err"), "");
}

}  // namespace
}  // namespace keyblock::test
