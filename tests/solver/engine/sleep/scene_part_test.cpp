// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a scene that is awake: what belongs to it, and that its state comes back
// into the whole without loss.
#include "solver/engine/sleep/scene_part.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/candidates.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

/// Boxes of 1 m in a row on a fixed base, and a bolt through the fourth and fifth.
class ScenePartTest : public testing::Test {
protected:
    ScenePartTest() : model_(makeModel(row())), state_(makeState(model_)) {
        state_.contacts = findContacts(model_, state_.blocks, {}, 1e-3, true);
        placeBolts(model_, state_);
        for (std::size_t i = 0; i < state_.contacts.size(); ++i)
            state_.contacts[i].slip = 1e-3 * static_cast<double>(i);
        for (std::size_t i = 1; i < state_.blocks.size(); ++i) state_.blocks[i].rest.asleep = true;
    }

    static Scene row() {
        Scene scene = emptyScene(10e9, 0.2, 30.0);
        scene.blocks = {boxBlock("base", {-1, -1}, {9, 0})};
        for (int i = 0; i < 8; ++i)
            scene.blocks.push_back(boxBlock("b" + std::to_string(i + 1), {1.0 * i, 0}, {i + 1.0, 1}));
        Support support;
        support.blockAt = Point(4.0, -0.5);
        scene.supports = {support};
        addBolt(scene, linearType(barArea(), 200e9), 3.2, 4.8, 8, PlateKind::None);
        return scene;
    }

    void wake(int block) { state_.blocks[block].rest = {}; }

    ScenePart part(double reach = 0.1) const { return {model_, state_, Loads{}, reach}; }

    std::vector<std::string> names(const ScenePart& part) const {
        std::vector<std::string> all;
        for (const BlockModel& block : part.model().blocks) all.push_back(block.name);
        return all;
    }

    Model model_;
    State state_;
};

using Names = std::vector<std::string>;

TEST_F(ScenePartTest, HasWhatIsAwakeAndWhatThatMayReach) {
    wake(2);
    const ScenePart own = part();
    EXPECT_EQ(names(own), (Names{"base", "b1", "b2", "b3"}));
    EXPECT_TRUE(own.model().bolts.empty());
    EXPECT_FALSE(own.model().blocks[2].asleep);
    EXPECT_TRUE(own.model().blocks[1].asleep);
    EXPECT_EQ(names(part(1.1)), (Names{"base", "b1", "b2", "b3", "b4"}));
    EXPECT_EQ(part(1.5).model().bolts.size(), 1U);  // it may reach the bolt
}

TEST_F(ScenePartTest, HasTheBoltsThatCrossABlockThatIsAwakeAndTheirOtherBlocks) {
    wake(4);
    const ScenePart own = part();
    EXPECT_EQ(names(own), (Names{"base", "b3", "b4", "b5"}));
    ASSERT_EQ(own.model().bolts.size(), 1U);
    std::vector<std::string> crossed;
    const State state = own.stateOf(state_);
    for (const Slot& slot : state.bolts[0].slots) crossed.push_back(own.model().blocks[slot.block].name);
    EXPECT_EQ(crossed, (Names{"b4", "b5"}));
}

TEST_F(ScenePartTest, GivesBackWhatItTook) {
    for (const int awake : {1, 4, 8}) {
        wake(awake);
        const ScenePart own = part();
        State back = state_;
        own.writeBack(own.stateOf(state_), back);
        EXPECT_EQ(back.contacts, state_.contacts);
        EXPECT_EQ(back.blocks, state_.blocks);
        EXPECT_EQ(back.bolts[0].nodes, state_.bolts[0].nodes);
        EXPECT_EQ(back.bolts[0].slots[0].block, state_.bolts[0].slots[0].block);
    }
}

TEST_F(ScenePartTest, GivesBackContactsThatHaveComeAndGone) {
    wake(4);
    const ScenePart own = part();
    State moved = own.stateOf(state_);
    const Contact gone = moved.contacts.front();
    moved.contacts.erase(moved.contacts.begin());
    Contact& slid = moved.contacts.back();
    slid.edge = slid.edge == 0 ? 1 : 0;
    std::sort(moved.contacts.begin(), moved.contacts.end(), comesBefore);
    State back = state_;
    own.writeBack(moved, back);
    EXPECT_EQ(back.contacts.size(), state_.contacts.size() - 1);
    EXPECT_TRUE(std::is_sorted(back.contacts.begin(), back.contacts.end(), comesBefore));
    EXPECT_EQ(own.stateOf(back).contacts, moved.contacts);
    EXPECT_NE(gone, own.stateOf(back).contacts.front());
}

TEST_F(ScenePartTest, HoldsUntilSomethingHasMovedAsFarAsItsReach) {
    wake(2);
    const ScenePart own = part(0.1);
    EXPECT_TRUE(own.holds(state_, 0.0));
    EXPECT_FALSE(own.holds(state_, 0.11));
    for (Point& corner : state_.blocks[2].corners) corner.y() += 0.06;
    EXPECT_TRUE(own.holds(state_, 0.03));
    EXPECT_FALSE(own.holds(state_, 0.05));
}

TEST_F(ScenePartTest, LoadsAreThoseOnItsBlocks) {
    wake(2);
    Loads loads;
    for (const int block : {7, 2, 8, 3}) loads.forces.push_back({block, {0.0, 0.0}, {1.0 * block, 0.0}});
    LoadPoint at;
    at.forces = {0.7, 0.2, 0.8, 0.3};
    const ScenePart own(model_, state_, loads, 0.1);
    ASSERT_EQ(own.loads().forces.size(), 2U);
    EXPECT_EQ(own.loads().forces[0].force.x(), 2.0);
    EXPECT_EQ(own.model().blocks[own.loads().forces[1].block].name, "b3");
    EXPECT_EQ(own.loadsAt(at).forces, (std::vector<double>{0.2, 0.3}));
}

}  // namespace
}  // namespace keyblock
