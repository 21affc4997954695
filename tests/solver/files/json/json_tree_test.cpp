// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/json/json_tree.h"

#include "solver/files/json/json_text.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(JsonTree, KnowsTheLineOfEveryValue) {
    const JsonReading reading = readJson("{\n\"a\": 1,\n\"b\": [2,\n3\n, {\"c\":\ntrue}]}");
    ASSERT_TRUE(reading.root);
    EXPECT_EQ(reading.root->line, 1);
    EXPECT_EQ(lineAt(*reading.root, "/a"), 2);
    EXPECT_EQ(lineAt(*reading.root, "/b"), 3);
    EXPECT_EQ(lineAt(*reading.root, "/b/0"), 3);
    EXPECT_EQ(lineAt(*reading.root, "/b/1"), 4);
    EXPECT_EQ(lineAt(*reading.root, "/b/2"), 5);
    EXPECT_EQ(lineAt(*reading.root, "/b/2/c"), 6);
    EXPECT_EQ(lineAt(*reading.root, "/b/2/missing"), 5) << "as far as the pointer leads";
}

TEST(JsonTree, FollowsEscapedPointers) {
    const JsonReading reading = readJson("{\n\"a/b~c\":\n1}");
    ASSERT_TRUE(reading.root);
    EXPECT_EQ(lineAt(*reading.root, "/a~1b~0c"), 3);
}

TEST(JsonTree, KeepsTheFirstOfDuplicateKeysAndTellsBothLines) {
    const JsonReading reading = readJson("{\"x\": {\n\"a\": 1,\n\"b\": 2,\n\"a\": 3}}");
    ASSERT_TRUE(reading.root);
    ASSERT_EQ(reading.problems.size(), 1u);
    EXPECT_EQ(reading.problems[0].pointer, "/x/a");
    EXPECT_EQ(reading.problems[0].line, 4);
    EXPECT_NE(reading.problems[0].message.find("line 2"), std::string::npos);
    EXPECT_EQ(jsonLine(*reading.root), R"({ "x": { "a": 1, "b": 2 } })");
}

TEST(JsonTree, TellsTheLineOfASyntaxError) {
    const JsonReading reading = readJson("{\n\"a\": 1\n\"b\": 2}");
    EXPECT_FALSE(reading.root);
    ASSERT_EQ(reading.problems.size(), 1u);
    EXPECT_EQ(reading.problems[0].line, 3);
}

TEST(JsonTree, ProblemsArePlainTextWhateverTheBytes) {
    for (const std::string text : {"{\"a\": \"\xff\"}", "{\"a\": \xc3\x28}", "\x80", "{\"\xed\xa0\x80\": 1}"}) {
        const JsonReading reading = readJson(text);
        ASSERT_EQ(reading.problems.size(), 1u);
        EXPECT_TRUE(isUtf8(reading.problems[0].message + reading.problems[0].pointer));
    }
}

TEST(JsonTree, NamesTheEncodingOfATextThatIsNotUtf8) {
    const auto message = [](std::string_view bytes) { return readJson(bytes).problems.at(0).message; };
    using namespace std::string_view_literals;
    for (const std::string_view text : {"\xFF\xFE{\0"sv, "\xFE\xFF\0{"sv, "{\0\n\0"sv, "\0{\0\n"sv, "{\0\"\0a\0"sv})
        EXPECT_EQ(message(text), "the text is UTF-16");
    for (const std::string_view text : {"\xFF\xFE\0\0{\0\0\0"sv, "\0\0\xFE\xFF\0\0\0{"sv, "{\0\0\0"sv, "\0\0\0{"sv})
        EXPECT_EQ(message(text), "the text is UTF-32");
    EXPECT_TRUE(readJson("{}").root);
}

TEST(JsonTree, RefusesZeroCharacters) {
    const JsonReading reading = readJson(R"({"title": "a\u0000b", "k\u0000": 1})");
    ASSERT_EQ(reading.problems.size(), 2u);
    EXPECT_EQ(reading.problems[0].pointer, "/title");
    for (const Problem& problem : reading.problems) {
        EXPECT_NE(problem.message.find("zero character (\\u0000)"), std::string::npos) << problem.message;
        EXPECT_EQ(oneLine(problem).find('\0'), std::string::npos);
    }
}

TEST(JsonTree, LongKeysAreShortenedInMessages) {
    const std::string key(90000, 'x'), tooLong(200000, 'y');
    const JsonReading twice = readJson("{\"" + key + "\": 1, \"" + key + "\": 2}");
    ASSERT_EQ(twice.problems.size(), 1u);
    EXPECT_LT(oneLine(twice.problems[0]).size(), 300u);
    EXPECT_NE(oneLine(twice.problems[0]).find("error: /xxx"), std::string::npos) << oneLine(twice.problems[0]);
    const JsonReading refused = readJson("{\"" + tooLong + "\": {\"a\": 1}}");
    EXPECT_FALSE(refused.root);
    ASSERT_EQ(refused.problems.size(), 1u);
    EXPECT_LT(oneLine(refused.problems[0]).size(), 300u);
}

TEST(JsonTree, AcceptsSixtyFourLevelsAndNoMore) {
    EXPECT_TRUE(readJson(std::string(64, '[') + std::string(64, ']')).root);
    EXPECT_FALSE(readJson(std::string(65, '[') + std::string(65, ']')).root);
}

TEST(JsonText, ReadsBackAsTheSameTree) {
    const std::string line =
        R"({ "text": "a\"b\\c\nd\u0001é", "numbers": [0, -1.5, 1e-300, 0.1, 123456789], "flags": [true, null], )"
        R"("e": {} })";
    const JsonReading reading = readJson(line);
    ASSERT_TRUE(reading.root);
    EXPECT_EQ(jsonLine(*reading.root), line);
    const JsonReading again = readJson(jsonText(*reading.root));
    ASSERT_TRUE(again.root);
    EXPECT_EQ(jsonLine(*again.root), line);
}

}  // namespace
}  // namespace keyblock
