// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sheet too large for the memory is refused with a message, not written as an empty
// file.
#include "ui/figure/paper.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(Papers, AnImageLargerThanTheMemoryIsRefused) {
    try {
        Paper(PaperFormat::Png, 40000.0, 40000.0, 1200, "wall");
        FAIL() << "two million pixels square were promised";
    } catch (const CannotDraw& problem) {
        EXPECT_NE(std::string(problem.what()).find("40000 × 40000 mm"), std::string::npos) << problem.what();
    }
}

}  // namespace
}  // namespace keyblock
