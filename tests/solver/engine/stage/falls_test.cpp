// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What counts as falling while rest is sought: a block that no pseudo-step slows
// down, after a way that no strain accounts for.
#include "solver/engine/stage/falls.h"

#include "solver/engine/setup/make_model.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace keyblock {
namespace {

constexpr double weight = 2700.0 * gravity;  // of a block of 1 m × 1 m

Scene oneBlock() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    return scene;
}

/// At rest; with a bolt in its first block, if asked.
State startOf(const Model& model, bool bolted) {
    State state = makeState(model);
    if (bolted) state.bolts.resize(1);
    if (bolted) state.bolts[0].slots.push_back({0});
    return state;
}

/// A block that is seen for some pseudo-steps and has then moved by a share of its size.
struct Watched {
    bool bolted = false;
    std::vector<Point> from{};  // centroid before the fall, if it was seen before
    Model model = makeModel(oneBlock());
    std::vector<BlockMotion> blocks = makeState(model).blocks;
    Falls falls{model, startOf(model, bolted), {1e-3, 0.01, from.empty() ? nullptr : &from}};

    /// \param acceleration of a pseudo-step, over gravity; its length, about `length` [s], is that of no other.
    void see(int steps, const std::function<double(int)>& acceleration, double length = 1e-3) {
        for (int step = 0; step < steps; ++step) {
            const double dt = length * (1.0 + step % 3);
            falls.note({0.5 * acceleration(step) * gravity * dt * dt}, dt, {weight});
        }
    }

    bool fallsAfter(double way) {
        blocks[0].centroid.y() -= way * model.blocks[0].size;
        const bool found = falls.falls(blocks, 0);
        blocks[0].centroid.y() += way * model.blocks[0].size;
        return found;
    }
};

TEST(Falls, ABlockThatNothingSlowsDownFalls) {
    Watched free;
    free.see(11, [](int) { return 1.0; });
    EXPECT_FALSE(free.fallsAfter(0.09));
    EXPECT_TRUE(free.fallsAfter(0.11));
    EXPECT_TRUE(free.falls.sameWhateverTheStep(0));
}

TEST(Falls, ABlockThatIsCaughtDoesNot) {
    Watched caught;
    caught.see(30, [](int step) { return std::pow(0.99, step); });
    EXPECT_FALSE(caught.fallsAfter(0.8));
}

/// Its acceleration falls by 4 % over a way of 1 % of its size, so that a bolt carries all of it after a quarter of its
/// size; over a way of half of its size it is not held in time.
TEST(Falls, ABlockThatItsBoltIsAboutToHoldDoesNot) {
    const auto losing = [](int step) { return 1.0 - 0.004 * step; };
    const auto lengthFor = [](double way) {  // of 10 pseudo-steps whose lengths are 1, 2 and 3 of it
        return std::sqrt(way / (0.5 * gravity * (3 * 14.0 + 4.0)));
    };
    for (const bool bolted : {true, false})
        for (const double way : {0.01, 0.5}) {
            Watched block{bolted};
            block.see(11, losing, lengthFor(way));
            EXPECT_EQ(block.fallsAfter(0.2), !bolted || way > 0.1) << bolted << " " << way;
        }
}

/// Slower than ten times what equilibrium allows, it has to go half of its size first; slower than that, it rests.
TEST(Falls, ASlowBlockHasToGoFurther) {
    Watched slow;
    slow.see(20, [](int) { return 5e-3; });
    EXPECT_FALSE(slow.fallsAfter(0.4));
    EXPECT_TRUE(slow.fallsAfter(0.6));
    Watched creeping;
    creeping.see(20, [](int) { return 0.9e-3; });
    EXPECT_FALSE(creeping.fallsAfter(0.9));
}

TEST(Falls, TenPseudoStepsShowNothing) {
    Watched early;
    early.see(10, [](int) { return 1.0; });
    EXPECT_FALSE(early.fallsAfter(0.9));
}

/// After a release the distance counts from where the fall began, and four pseudo-steps are enough.
TEST(Falls, AFallThatWasSeenBeforeIsSeenSooner) {
    Watched again{false, {Point(0.5, 0.61)}};
    again.see(3, [](int) { return 1.0; });
    EXPECT_FALSE(again.fallsAfter(0.0));
    again.see(1, [](int) { return 1.0; });
    EXPECT_TRUE(again.fallsAfter(0.0));
    Watched near{false, {Point(0.5, 0.59)}};
    near.see(4, [](int) { return 1.0; });
    EXPECT_FALSE(near.fallsAfter(0.0));
}

/// An acceleration that depends on the length of the step is that of a spring, not of a fall.
TEST(Falls, TheLengthOfTheStepMustNotMatter) {
    Watched pulled;
    pulled.see(12, [](int step) { return step == 11 ? 0.7 : 1.0; });
    EXPECT_FALSE(pulled.falls.sameWhateverTheStep(0));
}

}  // namespace
}  // namespace keyblock
