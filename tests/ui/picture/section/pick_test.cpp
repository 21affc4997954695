// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The object at a point of a section.
#include "tests/ui/bricks.h"
#include "ui/picture/section/pick.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

std::shared_ptr<SectionPicture> bricksPicture() {
    const test::BricksRun bricks;
    const MemoryRun run(bricks.scene, bricks.results);
    SectionRequest request;
    request.frame = 0;
    request.bolts = findQuantity(boltQuantities(), "axial_force");
    return std::make_shared<SectionPicture>(sectionPicture(run, request));
}

TEST(Pick, DistinguishesBlocksNodesAndBolts) {
    const PickIndex index(bricksPicture());
    const auto block = index.at({3.5, 0.5}, 0.05);
    ASSERT_TRUE(block);
    EXPECT_EQ(block->kind, PickKind::Block);
    EXPECT_EQ(block->block, 0);
    const auto bolt = index.at({1.02, 0.75}, 0.05);
    ASSERT_TRUE(bolt);
    EXPECT_EQ(bolt->kind, PickKind::Bolt);
    EXPECT_EQ(bolt->bolt, 0);
    EXPECT_EQ(bolt->element, 0);
    EXPECT_EQ(bolt->block, 0);
    const auto node = index.at({1.02, 1.01}, 0.05);
    ASSERT_TRUE(node);
    EXPECT_EQ(node->kind, PickKind::Node);
    EXPECT_EQ(node->node, 1);
    EXPECT_FALSE(index.at({-3.0, 0.0}, 0.05));
    EXPECT_FALSE(index.at({NAN, 0.0}, 0.05));
}

TEST(Pick, FindsTheRightBlockAmongFiveThousand) {
    auto picture = std::make_shared<SectionPicture>();
    for (int i = 0; i < 5000; ++i) {
        const Point at(i % 100, i / 100);
        BlockShape shape;
        shape.block = i;
        shape.outline = {at, at + Point(1.0, 0.0), at + Point(1.0, 1.0), at + Point(0.0, 1.0)};
        shape.before = shape.outline;
        picture->blocks.push_back(shape);
    }
    const PickIndex index(picture);
    for (int i = 0; i < 5000; i += 7) {
        const auto pick = index.at(Point(i % 100 + 0.3, i / 100 + 0.8), 0.1);
        ASSERT_TRUE(pick);
        EXPECT_EQ(pick->block, i);
    }
}

}  // namespace
}  // namespace keyblock
