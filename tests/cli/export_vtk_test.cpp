// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `export --vtk`: a folder for ParaView, whole or not at all. What stands in its
// files is the business of tests/vtk.
#include "tests/cli/command_line_fixture.h"

namespace keyblock::test {
namespace {

class ExportVtk : public CommandLine {
protected:
    void SetUp() override {
        putPullScene();
        ASSERT_EQ(keyblock({"run", "pull.json", "--progress", "none"}).code, 0);
    }
};

TEST_F(ExportVtk, WritesThreeTimeSeries) {
    const Ended ended = keyblock({"export", "pull.kbrun", "--vtk", "out/"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    for (const std::string kind : {"blocks", "bolts", "contacts"}) {
        EXPECT_NE(content("out/" + kind + ".pvd").find("file=\"" + kind + "/0000.vtp\""), std::string::npos);
        EXPECT_EQ(content("out/" + kind + "/0000.vtp").rfind("<?xml version=\"1.0\"?>", 0), 0U);
    }
    EXPECT_EQ(keyblock({"export", "pull.kbrun", "--vtk", "out", "--at", "last"}).code, 0);  // replaced
    EXPECT_TRUE(exists("out/blocks/0000.vtp"));
    EXPECT_FALSE(exists("out/blocks/0001.vtp"));
}

TEST_F(ExportVtk, LeavesAFolderWithOtherFilesAlone) {
    std::filesystem::create_directory(folder() / "mine");
    put("mine/notes.txt", "kept");
    const Ended ended = keyblock({"export", "pull.kbrun", "--vtk", "mine"});
    EXPECT_EQ(ended.code, 6);
    EXPECT_NE(ended.err.find("'notes.txt'"), std::string::npos) << ended.err;
    EXPECT_EQ(content("mine/notes.txt"), "kept");
}

TEST_F(ExportVtk, TakesNoOptionsOfTables) {
    for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
             {"--table", "blocks"}, {"--out", "t.csv"}, {"--bolt", "B"}}) {
        std::vector<std::string> words{"export", "pull.kbrun", "--vtk", "out"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(keyblock(words).code, 2) << more[0];
    }
    EXPECT_FALSE(exists("out"));
}

}  // namespace
}  // namespace keyblock::test
