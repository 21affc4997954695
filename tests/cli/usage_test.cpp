// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Words that the program does not take end with 2 and one line that helps; every
// verb explains itself.
#include "tests/cli/command_line_fixture.h"

#include <chrono>
#include <cstdlib>

namespace keyblock::test {
namespace {

class Usage : public CommandLine {
protected:
    void expectUsageError(const std::vector<std::string>& words, const std::string& part) const {
        const Ended ended = keyblock(words);
        EXPECT_EQ(ended.code, 2) << part;
        EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
        EXPECT_TRUE(ended.out.empty()) << ended.out;
    }
};

TEST_F(Usage, EveryVerbHasHelp) {
    const Ended whole = keyblock({"--help"});
    EXPECT_EQ(whole.code, 0);
    for (const std::string verb :
         {"run", "check", "info", "export", "import", "safety", "trade", "stress", "compare", "report", "sweep", "verify", "bolts"}) {
        EXPECT_NE(whole.out.find("\n  " + verb + " "), std::string::npos) << verb;
        const Ended ended = keyblock({verb, "--help"});
        EXPECT_EQ(ended.code, 0) << verb;
        EXPECT_NE(ended.out.find("keyblock " + verb), std::string::npos) << ended.out;
        EXPECT_TRUE(ended.err.empty()) << ended.err;
    }
}

TEST_F(Usage, VersionIsPrinted) {
    const std::vector<std::string> printed = lines(keyblock({"--version"}).out);
    ASSERT_EQ(printed.size(), 2u);
    EXPECT_TRUE(printed[0].starts_with("keyblock "));
    EXPECT_TRUE(printed[1].starts_with("OpenBLAS kernel "));
}

#if defined(__x86_64__)
TEST_F(Usage, TheKernelOfOpenBlasSuitsTheProcessorUnlessTheUserChoosesOne) {
    const auto kernel = [&](const std::map<std::string, std::string>& environment) {
        return lines(keyblock({"--version"}, environment).out).at(1).substr(std::string("OpenBLAS kernel ").size());
    };
    EXPECT_EQ(kernel({{"OPENBLAS_CORETYPE", "Prescott"}}), "Prescott");
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && !std::getenv("OPENBLAS_CORETYPE")) {
        EXPECT_NE(kernel({}), "Prescott");
    }
}
#endif

TEST_F(Usage, OnlyCommandsThatExistAreTaken) {
    for (const std::string verb : {"solve"}) expectUsageError({verb}, "there is no command '" + verb + "'");
    expectUsageError({}, "the command is missing");
}

TEST_F(Usage, WrongOptionsAreReported) {
    expectUsageError({"run"}, "SCENE.json");
    expectUsageError({"run", "scene.json", "--prest", "draft"}, "--prest");
    expectUsageError({"run", "scene.json", "--threads", "0"}, "--threads");
    expectUsageError({"run", "scene.json", "--threads", "many"}, "--threads");
    expectUsageError({"run", "scene.json", "--progress", "loud"}, "not one of bar, json, none");
    expectUsageError({"export", "run.kbrun", "--out", "t.csv"}, "--table");
    expectUsageError({"export", "run.kbrun", "--table", "energy", "--figure", "section", "--out", "t.csv"}, "--figure");
    expectUsageError({"export", "run.kbrun", "--table", "energy", "--dpi", "100", "--out", "t.csv"}, "--dpi");
    expectUsageError({"export", "run.kbrun", "--table", "stresses", "--out", "t.csv"}, "history, events, bolts");
    expectUsageError({"export", "run.kbrun", "--table", "energy", "--bolt", "B", "--out", "t.csv"}, "--bolt");
    expectUsageError({"import", "a.dxf"}, "--out");
    expectUsageError({"import", "a.dxf", "--out", "a.json", "--units", "cubit"}, "'cubit' is not one of m, mm, cm");
    expectUsageError({"import", "a.dxf", "--out", "a.json", "--role", "L=wall"}, "'L=wall' is not of the form LAYER=joint|boundary");
    expectUsageError({"import", "a.dxf", "--out", "a.json", "--sagitta", "0"}, "--sagitta");
    for (const std::string number : {"nan", "inf", "-nan"}) {
        expectUsageError({"export", "run.kbrun", "--figure", "section", "--width", number, "--out", "s.svg"},
                         "--width");
        expectUsageError({"export", "run.kbrun", "--figure", "section", "--deformed", number, "--out", "s.svg"},
                         "--deformed");
        expectUsageError({"import", "a.dxf", "--out", "a.json", "--sagitta", number}, "--sagitta");
    }
    expectUsageError({"verify", "--case", "no such case"}, "there is no case 'no such case'; there are ");
    expectUsageError({"verify", "--case", "free fall", "--paper"}, "--paper");
    expectUsageError({"bolts", "toothpick"}, "rebar-20");
    expectUsageError({"sweep"}, "subcommand is required");
    expectUsageError({"sweep", "plan", "study.json"}, "--out");
    expectUsageError({"sweep", "run", "folder", "--threads", "0"}, "--threads");
}

/// The verification takes minutes.
TEST_F(Usage, VerifyEndsWhenItsReaderHasGone) {
    const auto begun = std::chrono::steady_clock::now();
    const std::string words = "{ sleep 0.2; '" KEYBLOCK_PROGRAM "' verify; } | true";
    EXPECT_EQ(std::system(words.c_str()), 0);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(10));
}

}  // namespace
}  // namespace keyblock::test
