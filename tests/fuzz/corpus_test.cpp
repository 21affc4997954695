// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every input that the fuzzer found worth keeping, run again.
#include "tests/fuzz/drawing_property.h"
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

TEST(FuzzCorpus, EveryKeptDrawingHoldsTheProperty) {
    int inputs = 0;
    for (const char* folder : {"/tests/fuzz/drawing_corpus", "/tests/data/import"})
        for (const auto& entry : std::filesystem::directory_iterator(KEYBLOCK_SOURCE_DIR + std::string(folder))) {
            std::ifstream file(entry.path(), std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(file), {}};
            EXPECT_EQ(brokenDrawingProperty(bytes), "") << entry.path();
            ++inputs;
        }
    EXPECT_GE(inputs, 100);
}

TEST(FuzzProperty, AnAnswerIsGivenToNothingAndToNoise) {
    EXPECT_EQ(brokenSceneProperty(""), "");
    EXPECT_EQ(brokenDrawingProperty(""), "");
    EXPECT_EQ(brokenDrawingProperty(std::string_view("0\nSECTION\n\xff\n{[", 15)), "");
    EXPECT_EQ(brokenSceneProperty(std::string_view("\0\xff{[", 4)), "");
}

}  // namespace
}  // namespace keyblock
