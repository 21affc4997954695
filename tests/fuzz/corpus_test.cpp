// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every input that the fuzzer found worth keeping, run again.
#include "tests/fuzz/scene_property.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace keyblock {
namespace {

TEST(FuzzCorpus, EveryKeptInputHoldsTheProperty) {
    int inputs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(KEYBLOCK_SOURCE_DIR "/tests/fuzz/corpus")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(brokenSceneProperty(bytes), "") << entry.path();
        ++inputs;
    }
    EXPECT_GE(inputs, 50);
}

TEST(FuzzProperty, AnAnswerIsGivenToNothingAndToNoise) {
    EXPECT_EQ(brokenSceneProperty(""), "");
    EXPECT_EQ(brokenSceneProperty(std::string_view("\0\xff{[", 4)), "");
}

}  // namespace
}  // namespace keyblock
