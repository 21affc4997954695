// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The property of every cut, on random sections: on the first few in the suite, on
// as many as KEYBLOCK_CUTS says (200 take a minute or two).
#include "tests/geometry/cut/cut_property.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

namespace keyblock {
namespace {

std::uint64_t sections() {
    const char* given = std::getenv("KEYBLOCK_CUTS");
    return given ? std::strtoull(given, nullptr, 10) : 24;
}

TEST(CutProperty, HoldsOfRandomSectionsHalfOfThemDegenerate) {
    for (std::uint64_t seed = 0; seed < sections(); ++seed)
        EXPECT_EQ(brokenCut(randomSection(seed)), "") << "section " << seed;
}

TEST(CutProperty, HoldsOfSectionsMadeOfNoise) {
    std::mt19937_64 random(2);
    for (int i = 0; i < 300; ++i) {
        std::vector<std::uint8_t> bytes(20 + random() % 200);
        for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
        EXPECT_EQ(brokenCut(sectionOfBytes(bytes)), "") << "noise " << i;
    }
}

TEST(CutProperty, HoldsOfWhatTheFuzzerKept) {
    int inputs = 0;
    for (const auto& entry : std::filesystem::directory_iterator(KEYBLOCK_SOURCE_DIR "/tests/fuzz/cut_corpus")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
        EXPECT_EQ(brokenCut(sectionOfBytes(std::vector<std::uint8_t>(text.begin(), text.end()))), "") << entry.path();
        ++inputs;
    }
    EXPECT_GE(inputs, 10);
}

}  // namespace
}  // namespace keyblock
