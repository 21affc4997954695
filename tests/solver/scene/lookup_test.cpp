// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/lookup.h"

#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

Scene twoBlocks(const Point& shift = {0, 0}) {
    Scene scene;
    scene.materials = {{"soft", {2000, 1e9, 0.2}}, {"hard", {2700, 60e9, 0.17}}};
    scene.blocks.resize(2);
    scene.blocks[0].points = {{0, 0}, {3, 0}, {3, 4}, {0, 4}};
    scene.blocks[1].points = {{3, 0}, {6, 0}, {6, 4}, {3, 4}};
    scene.blocks[0].material = "hard";
    scene.blocks[1].material = "soft";
    scene.blocks[1].name = "right";
    for (Block& block : scene.blocks)
        for (Point& point : block.points)
            point += shift;
    return scene;
}

TEST(Lookup, ToleranceGrowsWithTheSceneAndItsDistance) {
    EXPECT_DOUBLE_EQ(sceneSize(twoBlocks()), std::sqrt(52.0));
    EXPECT_DOUBLE_EQ(geometricTolerance(twoBlocks()), 1e-9 * std::sqrt(52.0));
    EXPECT_GT(geometricTolerance(twoBlocks({1e8, 0})), 1e-8) << "doubles there are 1.5e-8 apart";
    EXPECT_DOUBLE_EQ(sceneSize(Scene{}), 1.0);
}

TEST(Lookup, BlockAtWantsTheInside) {
    const Scene scene = twoBlocks();
    EXPECT_EQ(blockAt(scene, {1, 1}), 0);
    EXPECT_EQ(blockAt(scene, {5, 1}), 1);
    EXPECT_EQ(blockAt(scene, {3, 1}), -1) << "on the joint";
    EXPECT_EQ(blockAt(scene, {3 + 1e-9, 1}), -1) << "within the tolerance of it";
    EXPECT_EQ(blockAt(scene, {3 + 1e-6, 1}), 1);
    EXPECT_EQ(blockAt(scene, {9, 1}), -1);
}

TEST(Lookup, BlockWithPointTakesTheBoundaryToo) {
    const Scene scene = twoBlocks();
    EXPECT_EQ(blockWithPoint(scene, {6, 4}), 1);
    EXPECT_EQ(blockWithPoint(scene, {3, 2}), 0) << "the first in order";
    EXPECT_EQ(blockWithPoint(scene, {6.1, 4}), -1);
}

TEST(Lookup, JointMaterialsFallBack) {
    Scene scene = twoBlocks();
    EXPECT_EQ(jointMaterialIndex(scene, scene.blocks[0]), -1);
    EXPECT_DOUBLE_EQ(jointMaterialAt(scene, -1).frictionAngle, 30.0);
    scene.jointMaterials = {{"rough", {40, 0, 0}}, {"smooth", {10, 0, 0}}};
    EXPECT_EQ(jointMaterialIndex(scene, scene.blocks[0]), 0);
    scene.blocks[0].jointMaterial = "smooth";
    EXPECT_EQ(jointMaterialIndex(scene, scene.blocks[0]), 1);
    EXPECT_DOUBLE_EQ(jointMaterialAt(scene, 1).frictionAngle, 10.0);
}

TEST(Lookup, FollowsNames) {
    Scene scene = twoBlocks();
    EXPECT_DOUBLE_EQ(materialOf(scene, scene.blocks[0]).density, 2700);
    EXPECT_EQ(displayName(scene, 0), "b1");
    EXPECT_EQ(displayName(scene, 1), "right");
    scene.boltTypes.resize(1);
    scene.boltTypes[0].name = "bar";
    scene.boltTypes[0].anchors.resize(2);
    Bolt bolt;
    bolt.type = "bar";
    EXPECT_EQ(anchorsOf(scene, bolt).size(), 2u);
    bolt.anchors.emplace();
    EXPECT_TRUE(anchorsOf(scene, bolt).empty());
    EXPECT_EQ(findBoltType(scene, "rod"), nullptr);
}

TEST(Lookup, CountsPlacesFromEitherEnd) {
    Monitor monitor;
    EXPECT_DOUBLE_EQ(distanceAlong(monitor, 2.0), 2.0);
    monitor.atFromHead = 0.5;
    EXPECT_DOUBLE_EQ(distanceAlong(monitor, 2.0), 1.5);
    monitor.atFraction = 0.1;
    EXPECT_DOUBLE_EQ(distanceAlong(monitor, 2.0), 0.2);
    monitor.at = 0.7;
    EXPECT_DOUBLE_EQ(distanceAlong(monitor, 2.0), 0.7);
    EXPECT_DOUBLE_EQ(distanceAlong(BoltPlace{true, 0.0}, 2.0), 2.0);
    EXPECT_DOUBLE_EQ(distanceAlong(BoltPlace{false, 0.3}, 2.0), 0.3);
}

TEST(Pointer, EscapesKeys) {
    EXPECT_EQ(under("/materials", "a/b~c"), "/materials/a~1b~0c");
    EXPECT_EQ(under("/blocks", std::size_t{3}), "/blocks/3");
    EXPECT_TRUE(isWithin("/blocks/1/points", "/blocks/1"));
    EXPECT_TRUE(isWithin("/blocks/1", "/blocks/1"));
    EXPECT_FALSE(isWithin("/blocks/10", "/blocks/1"));
}

TEST(Suggest, FindsTheNearestName) {
    const std::vector<std::string_view> names{"points", "material", "d-bolt-20"};
    EXPECT_EQ(nearestName("pionts", names), "points");
    EXPECT_EQ(nearestName("materal", names), "material");
    EXPECT_EQ(nearestName("d-bolt", names), "d-bolt-20");
    EXPECT_EQ(nearestName("colour", names), "");
    EXPECT_EQ(nearestName("x", {"y"}), "") << "nothing in common";
}

TEST(Suggest, QuotesLongTextsInPart) {
    EXPECT_EQ(inQuotes("a"), "'a'");
    const std::string umlauts = [] {
        std::string text;
        for (int i = 0; i < 100; ++i)
            text += "xü";
        return text;
    }();
    const std::string quoted = inQuotes(umlauts);
    EXPECT_LT(quoted.size(), 70u);
    EXPECT_TRUE(quoted.ends_with("…'"));
    EXPECT_NE(static_cast<unsigned char>(quoted[quoted.size() - 5]) & 0xC0, 0xC0) << "no half character";
}

}  // namespace
}  // namespace keyblock
