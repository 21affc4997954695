// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The example of the help page on the run store, run as it stands there.
#include "tests/cli/command_line_fixture.h"

#include <cstdlib>

namespace keyblock::test {
namespace {

class RunStorePage : public CommandLine {};

TEST_F(RunStorePage, ItsExampleReadsARun) {
    if (std::system("python3 -c 'import sqlite3' 2>/dev/null") != 0) GTEST_SKIP() << "there is no Python 3 here";
    const std::string page = contentOf(KEYBLOCK_SOURCE_DIR "/resources/help/run-store.md");
    const auto begin = page.find("```python\n") + 10;
    put("example.py", page.substr(begin, page.find("```", begin) - begin));
    putPullScene();
    ASSERT_EQ(keyblock({"run", "pull.json", "--progress", "none"}).code, 0);
    const std::string in = "cd '" + folder().string() + "' && ";
    ASSERT_EQ(std::system((in + "python3 example.py pull.kbrun > out.txt").c_str()), 0);
    const std::vector<std::string> printed = lines(content("out.txt"));
    ASSERT_GE(printed.size(), 6U);
    EXPECT_EQ(printed[0], "A joint opens across a bolt");
    EXPECT_EQ(printed[1], "stage pull (static): equilibrium at 1.0");
    EXPECT_EQ(printed[printed.size() - 3].rfind("dilation_m at the end: 0.00", 0), 0U) << printed[printed.size() - 3];
}

}  // namespace
}  // namespace keyblock::test
