// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wrong name after `--out` costs no file: not the one that is read, no run, no
// scene, and no file that was not named.
#include "tests/cli/command_line_fixture.h"

namespace keyblock::test {
namespace {

namespace fs = std::filesystem;

const std::string points = KEYBLOCK_TEST_DATA_DIR "/import/points.csv";

class Overwriting : public CommandLine {
protected:
    void runPull() const {
        putPullScene();
        ASSERT_EQ(keyblock({"run", "pull.json", "--progress", "none"}).code, 0);
    }
    /// Expects that the command ends with 2 and one error line for each of the parts, and leaves the files as they are.
    void expectRefused(const std::vector<std::string>& words, const std::vector<std::string>& parts,
                       const std::vector<std::string>& files) const {
        std::vector<std::string> before;
        for (const std::string& file : files) before.push_back(content(file));
        const Ended ended = keyblock(words);
        EXPECT_EQ(ended.code, 2) << words.back() << ": " << ended.err;
        EXPECT_EQ(lines(ended.err).size(), parts.size()) << ended.err;
        for (const std::string& part : parts) EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
        for (std::size_t i = 0; i < files.size(); ++i) EXPECT_EQ(content(files[i]), before[i]) << files[i];
    }
};

TEST_F(Overwriting, AnExportReplacesNeitherItsRunNorAScene) {
    runPull();
    fs::create_symlink("pull.kbrun", folder() / "link.csv");
    fs::create_hard_link(folder() / "pull.kbrun", folder() / "same.csv");
    fs::copy_file(folder() / "pull.kbrun", folder() / "other.csv");
    for (const std::string out : {"pull.kbrun", "link.csv", "same.csv"})
        expectRefused({"export", "pull.kbrun", "--table", "events", "--out", out}, {"is the file that is read"},
                      {"pull.kbrun"});
    expectRefused({"export", "pull.kbrun", "--table", "events", "--out", "other.csv"}, {"is a run store"},
                  {"other.csv"});
    expectRefused({"export", "pull.kbrun", "--table", "events", "--overwrite", "--out", "pull.json"}, {"is a scene"},
                  {"pull.json"});
    fs::create_symlink("pull.kbrun", folder() / "film.mp4");
    expectRefused({"export", "pull.kbrun", "--animation", "film.mp4"},
#ifdef KEYBLOCK_HAS_FIGURES
                  {"is the file that is read"},
#else
                  {"built without figures"},
#endif
                  {"pull.kbrun"});
}

TEST_F(Overwriting, ATableThatWasNamedIsReplaced) {
    runPull();
    put("events.csv", "an earlier table");
    EXPECT_EQ(keyblock({"export", "pull.kbrun", "--table", "events", "--out", "events.csv"}).code, 0);
    EXPECT_EQ(content("events.csv").rfind("stage,time_s,", 0), 0U) << content("events.csv");
}

TEST_F(Overwriting, AnImportReplacesASceneOnlyWhenAsked) {
    ASSERT_EQ(keyblock({"import", points, "--out", "scene.json"}).code, 0);
    const std::vector<std::string> words{"import", points, "--out", "scene.json"};
    put("scene.json", content("scene.json") + "\n\n");  // edited by hand
    expectRefused(words, {"scene.json exists; add --overwrite"}, {"scene.json"});
    std::vector<std::string> asked = words;
    asked.emplace_back("--overwrite");
    EXPECT_EQ(keyblock(asked).code, 0);
    EXPECT_FALSE(content("scene.json").ends_with("\n\n"));
}

TEST_F(Overwriting, AnImportReplacesNeitherItsDrawingNorARun) {
    runPull();
    fs::copy_file(points, folder() / "points.csv");
    fs::create_symlink("points.csv", folder() / "link.json");
    for (const std::string out : {"points.csv", "link.json"})
        expectRefused({"import", "points.csv", "--overwrite", "--out", out}, {"is the file that is read"},
                      {"points.csv"});
    expectRefused({"import", "points.csv", "--overwrite", "--out", "pull.kbrun"}, {"is a run store"}, {"pull.kbrun"});
}

#ifdef KEYBLOCK_HAS_FIGURES

TEST_F(Overwriting, DataOfAFigureReplaceOtherFilesOnlyWhenAsked) {
    runPull();
    put("s-blocks.csv", "mine");
    put("s-events.csv", "mine too");
    const std::vector<std::string> words{"export", "pull.kbrun", "--figure", "section", "--out", "s.svg"};
    expectRefused(words, {"s-blocks.csv exists; add --overwrite", "s-events.csv exists; add --overwrite"},
                  {"s-blocks.csv", "s-events.csv"});
    EXPECT_FALSE(exists("s.svg"));
    EXPECT_FALSE(exists("s-bolts.csv"));
    std::vector<std::string> asked = words;
    asked.emplace_back("--overwrite");
    EXPECT_EQ(keyblock(asked).code, 0);
    EXPECT_NE(content("s-blocks.csv"), "mine");
    EXPECT_EQ(keyblock(words).code, 0);  // the data are those of the figure already
}

TEST_F(Overwriting, AReferenceIsNotReplacedByTheDataOfItsFigure) {
    runPull();
    put("c-reference.csv", "load_kN;gap_mm\n0;0\n40,5;1\n");
    expectRefused({"export", "pull.kbrun", "--figure", "curves", "--reference", "c-reference.csv", "--overwrite",
                   "--out", "c.svg"},
                  {"is the file that is read"}, {"c-reference.csv"});
}

#endif

}  // namespace
}  // namespace keyblock::test
