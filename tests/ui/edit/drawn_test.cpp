// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/drawn.h"
#include "ui/edit/defaults.h"

#include <gtest/gtest.h>

namespace {

using namespace keyblock;

Scene rock() { return withDomain(newScene(), {{0, 0}, {10, 0}, {10, 10}, {0, 10}}).scene; }

Block blockOf(std::vector<Point> points) {
    Block block;
    block.points = std::move(points);
    return block;
}

TEST(Drawn, ObjectsGetNamesAndPointers) {
    const Scene scene = rock();
    const Edit joint = withJoint(scene, {"", {{1, 1}, {5, 5}}, {}});
    ASSERT_TRUE(joint.done()) << joint.refusal;
    EXPECT_EQ(joint.made, "/joints/0");
    EXPECT_EQ(joint.scene.joints[0].name, "J1");
    EXPECT_EQ(withJoint(joint.scene, {"J1", {{1, 1}, {5, 5}}, {}}).scene.joints[1].name, "J2");
    const Edit block = withBlock(scene, blockOf({{20, 0}, {21, 0}, {21, 1}}));
    EXPECT_EQ(block.scene.blocks[0].material, "granite");
    EXPECT_EQ(block.scene.blocks[0].name, "block 1");
    Load load;
    load.point = Point(5, 10);
    const Edit loaded = withLoad(scene, 1, load);
    EXPECT_EQ(loaded.made, "/stages/1/loads/0");
    Motion motion;
    EXPECT_EQ(withMotion(scene, 0, motion).made, "/stages/0/motions/0");
}

TEST(Drawn, SupportOfASideIsReplaced) {
    Support support;
    support.boundary = BoundarySide::Left;
    support.fix = Fix::XY;
    const Edit edit = withSupport(rock(), support);
    ASSERT_EQ(edit.scene.supports.size(), 3u);
    EXPECT_EQ(edit.made, "/supports/1");
    EXPECT_EQ(edit.scene.supports[1].fix, Fix::XY);
    support.boundary.reset();
    support.point = Point(5, 5);
    EXPECT_EQ(withSupport(rock(), support).scene.supports.size(), 4u);
}

TEST(Drawn, InvalidObjectsAreRefused) {
    const Scene scene = rock(), empty = newScene();
    EXPECT_FALSE(withJoint(scene, {"", {{1, 1}}, {}}).done());
    EXPECT_FALSE(withJoint(empty, {"", {{1, 1}, {2, 2}}, {}}).done());
    EXPECT_FALSE(withBlock(scene, blockOf({{0, 0}, {1, 0}})).done());
    EXPECT_FALSE(withRegion(scene, {"", {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}).done());
    EXPECT_FALSE(withJointSet(scene, {}).done());
    EXPECT_FALSE(withLoad(scene, 7, {}).done());
    Support side;
    side.boundary = BoundarySide::Top;
    EXPECT_FALSE(withSupport(empty, side).done());
}

}  // namespace
