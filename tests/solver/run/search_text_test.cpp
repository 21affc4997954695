// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What progress says of a long search for equilibrium.
#include "solver/run/run.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <string>

namespace keyblock {
namespace {

TEST(SearchProgress, NamesTheBlockThatMoves) {
    Scene scene = test::boxOnBase(45.0, 20.0);
    scene.stages = {test::settle()};
    MemorySink sink;
    Control control;
    std::string text;
    control.progress = [&](const Progress& progress) {
        const std::string now = searchText(progress.step, {"base", "box"});
        if (!now.empty()) text = now;
    };
    run(scene, sink, control);
    EXPECT_EQ(text.rfind("searching, ", 0), 0U) << text;
    EXPECT_NE(text.find(" solves: box moves "), std::string::npos) << text;
}

TEST(SearchProgress, SaysNothingOfShortSearchesAndOfMotion) {
    StepHealth step;
    step.searched = 3;
    EXPECT_EQ(searchText(step, {"a"}), "");
    step.searched = 40;
    EXPECT_EQ(searchText(step, {"a"}), "searching, 40 solves");
    step.moving = 0;
    step.moved = 0.01234;
    EXPECT_EQ(searchText(step, {"a"}), "searching, 40 solves: a moves 12.34 mm");
    step.moved = 1.5;
    EXPECT_EQ(searchText(step, {"a"}), "searching, 40 solves: a moves 1.5 m");
}

}  // namespace
}  // namespace keyblock
