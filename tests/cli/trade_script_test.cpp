// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The script of `make trade` with a program in place of `keyblock` that measures
// nothing: the page has all samples or is not written.
#include "tests/cli/command_line_fixture.h"

#include <chrono>
#include <cstdlib>

namespace keyblock::test {
namespace {

/// Writes a trade with one point; refuses a folder whose points are of another scene, as `keyblock trade` does.
constexpr const char* standIn = R"(#!/bin/sh
out=$4
mkdir -p "$out"
if grep -qs another "$out/points.json"; then
    echo "keyblock: cannot write $out: it holds the trade of another scene; choose another folder" >&2
    exit 6
fi
echo '{"build": "1"}' > "$out/points.json"
echo "axis,setting,quantity,value,error,wall_s,factorizations,on_front,order" > "$out/trade.csv"
echo "own settings,,last a.u,1,0,0.5,3,1," >> "$out/trade.csv"
printf 'against the finest settings (reference: x; 1 s)\nNo preset is recommended: none.\n' > "$out/trade.md"
)";

class TradeScript : public CommandLine {
protected:
    void SetUp() override {
        if (std::system("python3 -c '' 2>/dev/null") != 0) GTEST_SKIP() << "there is no Python 3 here";
        put("program", standIn);
        std::filesystem::permissions(folder() / "program", std::filesystem::perms::owner_all);
    }

    /// \return whether it ended with 0; its messages are in `err.txt`.
    bool script(const std::string& words) const {
        return std::system(("cd '" + folder().string() + "' && python3 " KEYBLOCK_SOURCE_DIR "/tests/trade/trade.py " +
                            words + " > out.txt 2> err.txt")
                               .c_str()) == 0;
    }

    std::size_t sections() const {
        std::size_t count = 0;
        for (const std::string& line : lines(content("page.md"))) count += line.starts_with("## ") ? 1 : 0;
        return count;
    }
};

TEST_F(TradeScript, WritesAllSamplesAndMeasuresAgainWhatDoesNotFit) {
    std::filesystem::create_directories(folder() / "trades/incline");
    put("trades/incline/points.json", "of another scene");
    ASSERT_TRUE(script("measure ./program --out trades")) << content("err.txt");
    EXPECT_NE(content("err.txt").find("incline: the trade in"), std::string::npos) << content("err.txt");
    ASSERT_TRUE(script("page trades page.md")) << content("err.txt");
    EXPECT_EQ(sections(), 8u);
}

TEST_F(TradeScript, RefusesAPageWithoutEverySample) {
    ASSERT_TRUE(script("measure ./program --out trades")) << content("err.txt");
    put("page.md", "as before");
    std::filesystem::remove(folder() / "trades/deep-drift/trade.csv");
    put("trades/incline.json", "{}");
    EXPECT_FALSE(script("page trades page.md"));
    EXPECT_NE(content("err.txt").find("deep-drift was not measured"), std::string::npos) << content("err.txt");
    EXPECT_NE(content("err.txt").find("incline is of another scene"), std::string::npos) << content("err.txt");
    EXPECT_EQ(content("page.md"), "as before");
    put("trades/rebar-20/points.json", R"({"build": "0"})");
    std::filesystem::last_write_time(folder() / "trades/rebar-20/points.json",
                                     std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    EXPECT_FALSE(script("page trades page.md"));
    EXPECT_NE(content("err.txt").find("rebar-20 is by another version"), std::string::npos) << content("err.txt");
}

/// A folder with anything else is not touched.
TEST_F(TradeScript, KeepsFilesThatAreNotOfATrade) {
    std::filesystem::create_directories(folder() / "trades/incline");
    put("trades/incline/points.json", "of another scene");
    put("trades/incline/notes.txt", "mine");
    ASSERT_TRUE(script("measure ./program --out trades --only incline")) << content("err.txt");
    EXPECT_EQ(content("trades/incline/notes.txt"), "mine");
}

}  // namespace
}  // namespace keyblock::test
