// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `import` as a user runs it: what it answers, what it leaves, and with which
// exit code. What it makes of drawings is the business of tests/solver/files.
#include "tests/cli/command_line_fixture.h"

namespace keyblock::test {
namespace {

const std::string data = KEYBLOCK_TEST_DATA_DIR "/import/";

class Import : public CommandLine {};

TEST_F(Import, WritesASceneThatChecks) {
    const Ended ended = keyblock({"import", data + "half-circle-bulge.dxf", "--out", "scene.json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    for (const std::string part :
         {"units m (from the file)", "guessed from its name", "assumed: material", "blocks of 96."})
        EXPECT_NE(ended.out.find(part), std::string::npos) << part << '\n' << ended.out;
    const Ended check = keyblock({"check", "scene.json"});
    EXPECT_EQ(check.code, 0) << check.err;
}

TEST_F(Import, TakesRolesUnitsAndSagitta) {
    const Ended refused = keyblock({"import", data + "layer-in-code-page.dxf", "--out", "scene.json"});
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("'Klüfte'"), std::string::npos) << refused.err;
    EXPECT_FALSE(exists("scene.json"));
    const Ended taken = keyblock({"import", data + "layer-in-code-page.dxf", "--out", "scene.json", "--units", "mm",
                                  "--role", "Klüfte=joint", "--role", "*=ignore", "--sagitta", "0.001"});
    EXPECT_EQ(taken.code, 0) << taken.err;
    EXPECT_NE(content("scene.json").find("[0.01, 0.005]"), std::string::npos) << content("scene.json");
    EXPECT_NE(taken.out.find("given for all others"), std::string::npos) << taken.out;
}

TEST_F(Import, ListsWhatWasNotTaken) {
    std::string dxf = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\njoints\n10\n0\n20\n0\n11\n9\n21\n1\n";
    for (int i = 0; i < 12; ++i) dxf += "0\nTEXT\n8\nnotes\n10\n0\n20\n0\n1\nwords\n";
    put("a.DXF", dxf + "0\nENDSEC\n0\nEOF\n");
    const std::vector<std::string> words{"import", "a.DXF", "--units", "m", "--out", "a.json"};
    const Ended some = keyblock(words);
    EXPECT_NE(some.out.find("and 2 more TEXT on layer 'notes'"), std::string::npos) << some.out;
    std::vector<std::string> withAll = words;
    withAll.insert(withAll.end(), {"--all", "--overwrite"});
    const Ended all = keyblock(withAll);
    EXPECT_NE(all.out.find("line 128: text is not geometry"), std::string::npos) << all.out;
}

TEST_F(Import, TellsOfFilesThatCannotBeReadOrWritten) {
    EXPECT_EQ(keyblock({"import", "nothing.dxf", "--out", "scene.json"}).code, 3);
    EXPECT_EQ(keyblock({"import", ".", "--out", "scene.json"}).code, 3);
    EXPECT_EQ(keyblock({"import", data + "points.csv", "--out", "no/folder/scene.json"}).code, 6);
}

}  // namespace
}  // namespace keyblock::test
