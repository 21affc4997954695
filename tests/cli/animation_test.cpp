// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `export --animation` as a user types it: films that another program counts,
// pictures that do not jump, and nothing left behind by what went wrong.
#include "tests/cli/command_line_fixture.h"
#include "tests/wait_for.h"

#include <signal.h>

#include <cstdio>
#include <regex>

namespace keyblock::test {
namespace {

namespace fs = std::filesystem;

class Animations : public CommandLine {
protected:
    Ended animate(const std::string& out, const std::vector<std::string>& more = {},
                  const std::map<std::string, std::string>& environment = {}) const {
        return keyblock(wordsFor(out, more), environment);
    }
    static std::vector<std::string> wordsFor(const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> words{"export", "pull.kbrun", "--animation", out};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    void SetUp() override {
        putPullScene();
        ASSERT_EQ(keyblock({"run", "pull.json", "--progress", "none"}).code, 0);
    }
    void expectUsage(const std::string& out, const std::vector<std::string>& more, const std::string& part) const {
        expectFailure(2, animate(out, more), part);
    }
    void expectFailure(int code, const Ended& ended, const std::string& part) const {
        EXPECT_EQ(ended.code, code) << part;
        EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
        EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
        for (const auto& entry : fs::directory_iterator(folder()))
            EXPECT_EQ(entry.path().string().find(".part-"), std::string::npos) << entry.path();
    }
    /// Frames that the run kept.
    std::size_t kept() const {
        std::smatch found;
        const std::string info = keyblock({"info", "pull.kbrun"}).out;
        return std::regex_search(info, found, std::regex("frames +([0-9]+)")) ? std::stoul(found[1]) : 0;
    }
    std::string path(const std::string& name) const { return (folder() / name).string(); }
};

#ifdef KEYBLOCK_HAS_FIGURES

/// Width and height of a PNG [px].
std::pair<unsigned, unsigned> sizeOf(const std::string& png) {
    const auto at = [&](std::size_t i) {
        unsigned value = 0;
        for (std::size_t k = i; k < i + 4; ++k) value = value << 8 | static_cast<unsigned char>(png.at(k));
        return value;
    };
    return {at(16), at(20)};
}

TEST_F(Animations, APictureForEachFrameAllOfOneSize) {
    const Ended ended = animate("film", {"--width", "100", "--dpi", "60"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.err.empty()) << ended.err;
    const std::vector<std::string> moments = lines(content("film/frames.csv"));
    ASSERT_EQ(moments.size(), kept() + 1);
    const auto size = sizeOf(content("film/frame-0001.png"));
    EXPECT_EQ(size.first, 236U);  // 100 mm at 60 dots an inch
    for (std::size_t i = 1; i < moments.size(); ++i) {
        const std::string name = moments[i].substr(0, moments[i].find(','));
        EXPECT_EQ(sizeOf(content("film/" + name)), size) << name;
    }
}

TEST_F(Animations, AnotherProcessPaintsTheSamePictures) {
    ASSERT_EQ(animate("a", {"--dpi", "60"}).code, 0);
    ASSERT_EQ(animate("b", {"--dpi", "60"}).code, 0);
    for (const auto& entry : fs::directory_iterator(folder() / "a")) {
        const std::string name = entry.path().filename().string();
        EXPECT_EQ(content("a/" + name), content("b/" + name)) << name;
    }
}

TEST_F(Animations, AFolderOfPicturesIsReplacedAndNoOther) {
    ASSERT_EQ(animate("film", {"--dpi", "60"}).code, 0);
    put("film/frame-9999.png", "old");
    ASSERT_EQ(animate("film", {"--dpi", "60"}).code, 0);
    EXPECT_FALSE(exists("film/frame-9999.png"));
    put("film/notes.txt", "mine");
    expectFailure(6, animate("film", {"--dpi", "60"}), "notes.txt");
    EXPECT_EQ(content("film/notes.txt"), "mine");
    EXPECT_TRUE(exists("film/frame-0001.png"));
}

#ifdef KEYBLOCK_HAS_FFMPEG

/// What a program prints.
std::string printedBy(const std::string& command) {
    std::string text;
    if (FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r")) {
        for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
        ::pclose(pipe);
    }
    return text;
}

TEST_F(Animations, AnotherProgramCountsTheFramesOfAFilm) {
    const std::string probe = "ffprobe -v error -count_frames -select_streams v -of default=nw=1 -show_entries "
                              "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames ";
    for (const auto& [name, codec] : {std::pair{"film.mp4", "h264"}, std::pair{"film.webm", "vp9"}}) {
        const Ended ended = animate(name, {"--width", "101", "--dpi", "75", "--fps", "8"});
        ASSERT_EQ(ended.code, 0) << ended.err;
        EXPECT_TRUE(ended.err.empty()) << ended.err;
        const std::string shown = printedBy(probe + path(name));
        for (const std::string& part : {"codec_name=" + std::string(codec), std::string("width=298"),
                                        std::string("pix_fmt=yuv420p"), std::string("r_frame_rate=8/1"),
                                        "nb_read_frames=" + std::to_string(kept())})
            EXPECT_NE(shown.find(part), std::string::npos) << part << " in\n" << shown;
    }
}

#endif

TEST_F(Animations, WithoutFfmpegTheFolderIsNamed) {
    put("film.mp4", "old");
    expectFailure(6, animate("film.mp4", {}, {{"PATH", ""}}), "name a folder");
    EXPECT_EQ(content("film.mp4"), "old");
    EXPECT_EQ(animate("film", {"--dpi", "60"}, {{"PATH", ""}}).code, 0);
}

TEST_F(Animations, WhatFfmpegSaysIsPrintedOnOneLine) {
    fs::create_directory(folder() / "bin");
    put("bin/ffmpeg", "#!/bin/sh\necho no such codec >&2\necho more >&2\nexit 1\n");
    fs::permissions(folder() / "bin/ffmpeg", fs::perms::owner_all);
    expectFailure(6, animate("film.mp4", {"--dpi", "60"}, {{"PATH", path("bin")}}), "ffmpeg failed: no such codec");
    EXPECT_FALSE(exists("film.mp4"));
}

TEST_F(Animations, AnFfmpegThatWritesNothingIsAnError) {
    fs::create_directory(folder() / "bin");
    put("bin/ffmpeg", "#!/bin/sh\nexec /bin/cat >/dev/null\n");
    fs::permissions(folder() / "bin/ffmpeg", fs::perms::owner_all);
    expectFailure(6, animate("film.mp4", {"--dpi", "60"}, {{"PATH", path("bin")}}), "it wrote nothing");
    EXPECT_FALSE(exists("film.mp4"));
}

TEST_F(Animations, MessagesNameTheFileAsTheUserDid) {
    const Ended ended = animate("no/folder/film.mp4");
    EXPECT_EQ(ended.code, 6);
    EXPECT_NE(ended.err.find("no/folder/film.mp4: "), std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find(".part-"), std::string::npos) << ended.err;
}

TEST_F(Animations, StopsAtOnceAndLeavesNothing) {
    fs::create_directory(folder() / "bin");
    put("bin/ffmpeg", "#!/bin/sh\nexec /bin/sleep 600\n");  // reads nothing, and outlasts the test
    fs::permissions(folder() / "bin/ffmpeg", fs::perms::owner_all);
    Program program(wordsFor("film.mp4", {}), folder(), {{"PATH", path("bin")}});
    const auto isWaiting = [&] {
        for (const auto& entry : fs::directory_iterator(folder()))
            if (entry.path().string().find(".part-") != std::string::npos) return true;
        return false;
    };
    ASSERT_TRUE(waitFor(isWaiting));
    program.signal(SIGINT);
    expectFailure(75, program.wait(), "interrupted");
    EXPECT_FALSE(exists("film.mp4"));
}

TEST_F(Animations, WhatCannotBeMadeIsAUsageError) {
    expectUsage("film.avi", {}, ".mp4 or .webm");
    expectUsage("film.mp4", {"--at", "last"}, "all frames");
    expectUsage("film.mp4", {"--out", "x.png"}, "omit --out");
    expectUsage("film", {"--fps", "5"}, "--fps applies to");
    expectUsage("film.mp4", {"--fps", "0"}, "--fps");
    expectUsage("film.mp4", {"--quantity", "colour"}, "sigma1");
    expectUsage("film.mp4", {"--table", "events"}, "--table");
    expectFailure(6, animate("nowhere/film.mp4"), "create its folder first");
    expectFailure(6, animate("nowhere/film", {"--dpi", "60"}), "create its folder first");
    const Ended table = keyblock({"export", "pull.kbrun", "--table", "events", "--out", "e.csv", "--fps", "5"});
    expectFailure(2, table, "--fps applies to --animation");
}

#else

TEST_F(Animations, ABuildWithoutThemSaysSo) { expectUsage("film.mp4", {}, "built without figures"); }

#endif

}  // namespace
}  // namespace keyblock::test
