// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints that slip or open are reported once in a stage, with their forces.
#include "solver/run/watch.h"

#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

Scene towerOfThree() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    for (const double level : {0.0, 1.0, 2.0}) scene.blocks.push_back(boxBlock("", {0, level}, {1, level + 1.0}));
    return scene;
}

/// A tower of three boxes whose joints carry forces, and the watch over it.
class Watching {
public:
    Watching() {
        state.contacts = findContacts(model, state.blocks, {}, 1e-3, true);
        double force = 0.0;
        for (Contact& c : state.contacts) c.normalForce = force += 1.0;
        watch.beginStage(state);
    }

    /// Removes the contacts between two blocks.
    void open(int a, int b) {
        std::erase_if(state.contacts,
                      [&](const Contact& c) { return std::minmax(c.blockA, c.blockB) == std::minmax(a, b); });
    }

    /// First contact between two blocks.
    Contact& between(int a, int b) {
        return *std::ranges::find_if(
            state.contacts, [&](const Contact& c) { return std::minmax(c.blockA, c.blockB) == std::minmax(a, b); });
    }

    Model model = makeModel(towerOfThree());
    State state = makeState(model);
    WatchMemory memory;
    Watch watch{model, state, memory};
};

TEST(Watch, ReportsAJointThatOpensOnceWithItsLastForces) {
    Watching tower;
    const std::vector<Contact> closed = tower.state.contacts;
    const Contact last = tower.between(0, 1);
    tower.open(0, 1);
    const std::vector<Event> events = tower.watch.look(tower.state);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, EventKind::JointOpen);
    EXPECT_EQ(std::pair(events[0].block, events[0].otherBlock), std::pair(0, 1));
    EXPECT_EQ(events[0].axialForce, -last.normalForce);
    EXPECT_EQ(events[0].position, last.position);
    EXPECT_TRUE(tower.watch.look(tower.state).empty());
    tower.state.contacts = closed;  // it closes and opens again
    EXPECT_TRUE(tower.watch.look(tower.state).empty());
    tower.open(0, 1);
    EXPECT_TRUE(tower.watch.look(tower.state).empty());
    tower.open(1, 2);
    EXPECT_EQ(tower.watch.look(tower.state).size(), 1u);
}

TEST(Watch, ReportsAJointThatSlipsOnce) {
    Watching tower;
    Contact& sliding = tower.between(1, 2);
    sliding.slip = sliding.shearForce = sliding.limit = 0.5;
    const std::vector<Event> events = tower.watch.look(tower.state);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, EventKind::JointSlip);
    EXPECT_EQ(std::pair(events[0].block, events[0].otherBlock), std::pair(1, 2));
    EXPECT_EQ(events[0].shearForce, 0.5);
    EXPECT_TRUE(tower.watch.look(tower.state).empty());
}

TEST(Watch, KeepsTheJointsOfSleepingBlocksAsTheyAre) {
    Watching tower;
    for (const int block : {1, 2}) tower.state.blocks[block].rest.asleep = true;
    tower.open(0, 1);
    tower.open(1, 2);  // contacts between sleeping blocks are not looked at
    ASSERT_EQ(tower.watch.look(tower.state).size(), 1u);
    for (const int block : {1, 2}) tower.state.blocks[block].rest.asleep = false;
    const std::vector<Event> events = tower.watch.look(tower.state);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(std::pair(events[0].block, events[0].otherBlock), std::pair(1, 2));
}

TEST(Watch, SortsTheJointsOfContactsInAnyOrder) {
    Watching tower;
    std::ranges::reverse(tower.state.contacts);
    EXPECT_TRUE(tower.watch.look(tower.state).empty());
    ASSERT_EQ(tower.memory.closed.size(), 2u);
    EXPECT_EQ(tower.memory.closed[0].blocks, std::pair(0, 1));
    EXPECT_EQ(tower.memory.closed[1].blocks, std::pair(1, 2));
}

}  // namespace
}  // namespace keyblock
