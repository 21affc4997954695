// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `export --figure` as a user types it; a build without figures says so.
#include "tests/cli/command_line_fixture.h"

namespace keyblock::test {
namespace {

class Figures : public CommandLine {
protected:
    Ended figure(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"export", "pull.kbrun", "--figure"};
        words.insert(words.end(), more.begin(), more.end());
        return keyblock(words);
    }
    void runPull() const {
        putPullScene();
        ASSERT_EQ(keyblock({"run", "pull.json", "--progress", "none"}).code, 0);
    }
};

#ifdef KEYBLOCK_HAS_FIGURES

TEST_F(Figures, ASectionComesWithItsData) {
    runPull();
    for (const std::string ending : {"svg", "pdf", "png"}) {
        const Ended ended = figure({"section", "--width", "120", "--out", "s." + ending});
        EXPECT_EQ(ended.code, 0) << ended.err;
        EXPECT_TRUE(ended.err.empty()) << ended.err;
        EXPECT_TRUE(exists("s." + ending));
    }
    for (const std::string table : {"blocks", "bolts", "events"}) EXPECT_TRUE(exists("s-" + table + ".csv")) << table;
    EXPECT_NE(content("s.svg").find("120mm"), std::string::npos);
}

TEST_F(Figures, ForcesOfContactsComeWithTheirTable) {
    runPull();
    const Ended ended = figure({"section", "--quantity", "contact-forces", "--out", "c.svg"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(content("c.svg").find("Contact force"), std::string::npos);
    EXPECT_NE(content("c-contacts.csv").find(",nx,ny"), std::string::npos);
}

TEST_F(Figures, AnotherProcessPaintsTheSameBytes) {
    runPull();
    for (const std::string ending : {"svg", "pdf", "png"}) {
        ASSERT_EQ(figure({"section", "--out", "a." + ending}).code, 0);
        ASSERT_EQ(figure({"section", "--out", "b." + ending}).code, 0);
        EXPECT_EQ(content("a." + ending), content("b." + ending)) << ending;
    }
}

TEST_F(Figures, AReferenceStandsBesideTheCurves) {
    runPull();
    put("lab.csv", "load_kN;gap_mm\n0;0\n40,5;1\n");
    const Ended ended = figure({"curves", "--reference", "lab.csv", "--out", "c.svg"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.err.empty()) << ended.err;
    EXPECT_NE(content("c.svg").find(">lab<"), std::string::npos);
    EXPECT_EQ(content("c-reference.csv"), "load_N,gap_m\n0,0\n40500,0.001\n");
}

TEST_F(Figures, AReferenceThatIsWrongIsReportedWithItsPosition) {
    runPull();
    put("words.csv", "gap_mm,load_kN\n0,0\n1,much\n");
    put("other.csv", "gap_mm,work_J\n0,0\n1,2\n");
    Ended ended = figure({"curves", "--reference", "words.csv", "--out", "c.svg"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_NE(ended.err.find("words.csv:3"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("'much'"), std::string::npos) << ended.err;
    ended = figure({"curves", "--reference", "other.csv", "--out", "c.svg"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("no panel matches"), std::string::npos) << ended.err;
    ended = figure({"section", "--reference", "words.csv", "--out", "c.svg"});
    EXPECT_EQ(ended.code, 2);
    ended = figure({"curves", "--reference", "none.csv", "--out", "c.svg"});
    EXPECT_EQ(ended.code, 3);
    EXPECT_FALSE(exists("c.svg"));
}

TEST_F(Figures, WhatCannotBeDrawnIsAUsageError) {
    runPull();
    const auto expectUsage = [&](const std::vector<std::string>& words, const std::string& part) {
        const Ended ended = figure(words);
        EXPECT_EQ(ended.code, 2) << part;
        EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
    };
    expectUsage({"map", "--out", "s.svg"}, "there is no figure 'map'");
    expectUsage({"section", "--out", "s.jpg"}, ".svg, .pdf or .png");
    expectUsage({"section", "--out", "s.svg", "--dpi", "100"}, "--dpi applies to PNG");
    expectUsage({"section", "--out", "s.svg", "--at", "all"}, "one frame");
    expectUsage({"section", "--out", "s.svg", "--quantity", "colour"}, "sigma1");
    expectUsage({"section", "--out", "s.svg", "--width", "10"}, "--width");
    EXPECT_FALSE(exists("s.svg"));
}

#else

TEST_F(Figures, ABuildWithoutThemSaysSo) {
    runPull();
    const Ended ended = figure({"section", "--out", "s.svg"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_NE(ended.err.find("built without figures"), std::string::npos) << ended.err;
}

#endif

}  // namespace
}  // namespace keyblock::test
