// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which scenes are pull tests, whose bolts need no elements for a dowel, and what
// the model makes of a bond that softens.
#include "solver/engine/setup/make_model.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace keyblock {
namespace {

Scene pullTest() {
    Scene scene = twoBlocks(60e9, 1.0, 2.0);
    addBolt(scene, linearType(barArea(), 200e9), 0.1, 1.9, 1, PlateKind::None);
    scene.bolts[0].divisions.reset();
    scene.stages = {pullStage(scene, 1e-3, 1)};
    return scene;
}

bool shears(const std::function<void(Scene&)>& change) {
    Scene scene = pullTest();
    change(scene);
    return makeModel(scene).bolts[0].shears;
}

TEST(ActsAcross, OnlyAPullTestShearsNothing) {
    EXPECT_FALSE(shears([](Scene&) {}));
    EXPECT_FALSE(shears([](Scene& s) { s.stages = {loadStage(s, 1e3, 1)}; }));
    EXPECT_TRUE(shears([](Scene& s) { s.analysis.gravity = {0.0, -9.81}; }));
    EXPECT_TRUE(shears([](Scene& s) { s.analysis.gravity = {-9.81, 0.0}; })) << "layers may slide under a roof bolt";
    EXPECT_TRUE(shears([](Scene& s) { s.inSituStress = InSituStress{}; }));
    EXPECT_TRUE(shears([](Scene& s) { s.stages[0].motions[0].axis = {1.0, 0.1}; }));
    EXPECT_TRUE(shears([](Scene& s) { s.stages[0].motions[0].rotation = Rotation::Free; }));
    EXPECT_TRUE(shears([](Scene& s) { s.blocks[1].points[0].x() = s.blocks[0].points[1].x() = 1.1; }));
    EXPECT_TRUE(shears([](Scene& s) { s.stages[0].dilations.resize(1); }));
    EXPECT_TRUE(shears([](Scene& s) { s.bolts.push_back(s.bolts[0]); }));
    EXPECT_TRUE(shears([](Scene& s) {
        s.stages = {loadStage(s, 1e3, 1)};
        s.stages[0].loads[0].at = Point(1.5, 0.7);  // turns the block
    }));
}

TEST(ActsAcross, APullTestHasFewerElements) {
    Scene weighty = pullTest();
    weighty.analysis.gravity = {0.0, -9.81};
    EXPECT_LT(2 * makeModel(pullTest()).bolts[0].s.size(), makeModel(weighty).bolts[0].s.size());
}

/// The peak is reached later, and the slip from there to the residual stays.
TEST(SofteningBond, ADynamicFactorKeepsTheSlip) {
    Scene scene = pullTest();
    Anchor soft = anchorRange(Per::Length, AnchorLaw::PeakResidual, 1e9, 1e5, 1e4);
    soft.softeningSlip = 1e-4;
    scene.boltTypes[0].anchors = {soft};
    scene.boltTypes[0].dynamicFactor = 3.0;
    const BoltModel bolt = makeModel(scene).bolts[0];
    const auto real = std::ranges::find_if(bolt.anchors, [](const AnchorModel& anchor) { return anchor.real; });
    ASSERT_NE(real, bolt.anchors.end());
    ASSERT_TRUE(real->curve && real->dynamicCurve);
    EXPECT_NEAR(real->curve->lastStrain, 1e-4 + 1e-4, 1e-15);
    EXPECT_NEAR(real->dynamicCurve->lastStrain, 3e-4 + 1e-4, 1e-15);
    EXPECT_NEAR(real->dynamicCurve->force.front(), 3e5, 1e-6);
    EXPECT_NEAR(real->dynamicCurve->force.back(), 3e4, 1e-6);
    EXPECT_NEAR(respond(*real->dynamicCurve, {}, 3.5e-4).force, 0.5 * (3e5 + 3e4), 1.0);
}

}  // namespace
}  // namespace keyblock
