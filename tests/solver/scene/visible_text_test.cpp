// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/visible_text.h"
#include "solver/scene/xml_text.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using namespace std::string_literals;

TEST(VisibleText, ControlCharactersAreShownAsEscapes) {
    EXPECT_EQ(visibleText("\x1b[2J\x07"), "\\u001b[2J\\u0007");
    EXPECT_EQ(visibleText("a\0b\x7f"s), "a\\u0000b\\u007f");
    EXPECT_EQ(visibleText("\u0085\u009b\u2028"), "\\u0085\\u009b\\u2028");
    EXPECT_EQ(visibleText("one\ntwo\r\n\tthree"), "one\\ntwo\\r\\n\\tthree");
    EXPECT_EQ(visibleLines("one\ntwo\r\n"), "one\ntwo\\r\n");
}

TEST(VisibleText, OverridesOfTheDirectionAreShownAsEscapes) {
    EXPECT_EQ(visibleText("a\u202Eb\u202Cc"), "a\\u202eb\\u202cc");
    EXPECT_EQ(visibleText("\u2066x\u2069"), "\\u2066x\\u2069");
}

TEST(VisibleText, OtherTextStays) {
    const std::string text = "Klüfte, 接合, עברית, 🪨 – 25 °, C:\\rock";
    EXPECT_EQ(visibleText(text), text);
    EXPECT_EQ(visibleLines(text), text);
}

TEST(VisibleText, BytesThatAreNotUtf8AreReplaced) {
    EXPECT_EQ(visibleText("\x9b[2J"), "\uFFFD[2J");
    EXPECT_EQ(visibleText("a\xC0\x80"), "a\uFFFD\uFFFD");  // an overlong NUL
    EXPECT_EQ(visibleText("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
    EXPECT_EQ(visibleText("\xE2\x82"), "\uFFFD\uFFFD");  // a character that breaks off
}

TEST(XmlText, EscapesMarkupAndLeavesOutWhatIsForbidden) {
    EXPECT_EQ(xmlText("a & b < c > d \" '"), "a &amp; b &lt; c &gt; d &quot; &#39;");
    EXPECT_EQ(xmlText("a\0\x1b\tb\nc\uFFFE\uFFFF\u0085"s), "a\tb\nc\u0085");
    EXPECT_EQ(xmlText("\xFF"), "\uFFFD");
}

}  // namespace
}  // namespace keyblock
