// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/time_cursor.h"

#include "tests/ui/bricks.h"
#include "tests/ui/screen/screen.h"
#include "ui/runs/live_run.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

/// Two stages of five frames each, at 0, 0.25 … 1, with events between and at frames.
std::shared_ptr<LiveRun> tenFrames() {
    Scene scene = test::bricks();
    scene.stages.push_back(scene.stages.front());
    auto run = std::make_shared<LiveRun>("nowhere.kbrun",
                                         LiveStart{std::make_shared<const Scene>(scene), HistoryColumns{}});
    LiveBatch batch;
    batch.stagesBegun = {0, 1};
    for (int stage = 0; stage < 2; ++stage)
        for (int i = 0; i < 5; ++i) batch.frames.push_back({stage, 0.25 * i, 10L * stage + i, {}});
    const auto add = [&](int stage, double time, EventKind kind) {
        Event event;
        event.stage = stage;
        event.time = time;
        event.kind = kind;
        batch.events.push_back(event);
    };
    add(0, 0.3, EventKind::Debonding);
    add(0, 0.35, EventKind::JointSlip);
    add(0, 0.75, EventKind::Yield);
    add(1, 0.6, EventKind::JointSlip);
    add(1, 0.9, EventKind::PlateLoss);
    test::countEvents(batch.events, batch.frames);
    run->append(std::move(batch));
    return run;
}

class TimeCursorTest : public ::testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }
};

TEST_F(TimeCursorTest, JumpsFromEventToEvent) {
    TimeCursor cursor;
    EXPECT_FALSE(cursor.nextEvent());  // without a run
    cursor.setRun(tenFrames(), false);
    cursor.home();
    EXPECT_EQ(cursor.frame(), 0u);
    std::vector<std::size_t> forward;
    while (cursor.nextEvent()) forward.push_back(*cursor.frame());
    EXPECT_EQ(forward, (std::vector<std::size_t>{2, 3, 9}));  // not at slips, and two events between frames are one jump
    std::vector<std::size_t> back;
    while (cursor.previousEvent()) back.push_back(*cursor.frame());
    EXPECT_EQ(back, (std::vector<std::size_t>{3, 2}));
    const auto ahead = [&] {
        cursor.home();
        std::vector<std::size_t> frames;
        while (cursor.nextEvent()) frames.push_back(*cursor.frame());
        return frames;
    };
    cursor.setHidden(EventKind::Yield, true);
    EXPECT_EQ(ahead(), (std::vector<std::size_t>{2, 9}));
    cursor.setHidden(EventKind::Debonding, true);
    cursor.setHidden(EventKind::PlateLoss, true);
    EXPECT_EQ(ahead(), (std::vector<std::size_t>{2, 8}));  // only slips are shown
    cursor.setHidden(EventKind::JointSlip, true);
    EXPECT_FALSE(cursor.hasNextEvent());
}

TEST_F(TimeCursorTest, StopsJustBeforeAndJustAfterAnEvent) {
    auto run = std::make_shared<LiveRun>("nowhere.kbrun",
                                         LiveStart{std::make_shared<const Scene>(test::bricks()), HistoryColumns{}});
    LiveBatch batch;
    batch.stagesBegun = {0};
    Event event;
    event.time = 0.3;
    event.kind = EventKind::Debonding;
    batch.events = {event};
    batch.frames = {{0, 0.0, 0, {}, 0}, {0, 0.3, 3, {}, 0}, {0, 0.3, 3, {}, 1}, {0, 1.0, 9, {}, 1}};
    run->append(std::move(batch));
    TimeCursor cursor;
    cursor.setRun(run, false);
    cursor.home();
    std::vector<std::size_t> forward, back;
    while (cursor.nextEvent()) forward.push_back(*cursor.frame());
    EXPECT_EQ(forward, (std::vector<std::size_t>{1, 2}));
    cursor.end();
    while (cursor.previousEvent()) back.push_back(*cursor.frame());
    EXPECT_EQ(back, (std::vector<std::size_t>{2, 1}));
    cursor.goToEvent(event);
    EXPECT_EQ(cursor.frame(), 2u);
}

TEST_F(TimeCursorTest, KnowsWhetherItCanStepForwardsAndBackwards) {
    TimeCursor cursor;
    EXPECT_FALSE(cursor.canStep(1) || cursor.canStep(-1) || cursor.canGoHome() || cursor.canGoToEnd());
    EXPECT_FALSE(cursor.hasNextEvent() || cursor.hasPreviousEvent());
    const auto run = tenFrames();
    cursor.setRun(run, false);
    EXPECT_TRUE(cursor.canStep(-1) && cursor.canGoHome() && cursor.hasPreviousEvent());
    EXPECT_FALSE(cursor.canStep(1) || cursor.canGoToEnd() || cursor.hasNextEvent());
    cursor.home();
    EXPECT_TRUE(cursor.canStep(1) && cursor.canGoToEnd() && cursor.hasNextEvent());
    EXPECT_FALSE(cursor.canStep(-1) || cursor.canGoHome() || cursor.hasPreviousEvent());
    cursor.setRun(run, true);  // followed: the end is here until the user steps back
    EXPECT_FALSE(cursor.canStep(1) || cursor.canGoToEnd());
    EXPECT_TRUE(cursor.canStep(-1) && cursor.canGoHome());
    cursor.step(-1);
    EXPECT_TRUE(cursor.canGoToEnd());
}

TEST_F(TimeCursorTest, StepsAndJumpsStayWithinTheRun) {
    TimeCursor cursor;
    cursor.step(1);
    cursor.home();
    cursor.end();
    cursor.play();
    EXPECT_FALSE(cursor.hasMoment());
    cursor.setRun(tenFrames(), false);
    EXPECT_EQ(cursor.frame(), 9u);
    cursor.step(5);
    EXPECT_EQ(cursor.frame(), 9u);
    cursor.step(-100);
    EXPECT_EQ(cursor.frame(), 0u);
    cursor.goTo(StageTime{1, 0.6});
    EXPECT_EQ(cursor.frame(), 7u);
    cursor.goTo(StageTime{0, -1.0});
    EXPECT_EQ(cursor.frame(), 0u);
    cursor.goTo(1000);
    EXPECT_EQ(cursor.frame(), 9u);
    cursor.toggleBookmark();
    EXPECT_TRUE(cursor.bookmarks().contains(9));
    cursor.toggleBookmark();
    EXPECT_TRUE(cursor.bookmarks().empty());
    cursor.setCursorB(99);
    EXPECT_EQ(cursor.cursorB(), std::nullopt);
}

TEST_F(TimeCursorTest, PlaysToTheEndAndLoops) {
    TimeCursor cursor;
    cursor.setRun(tenFrames(), false);
    cursor.setSpeed(4.0);
    cursor.play();  // from the start, as it is at the end
    EXPECT_TRUE(waitFor([&] { return !cursor.isPlaying(); }));
    EXPECT_EQ(cursor.frame(), 9u);
    cursor.setLoops(true);
    int turns = 0;
    QObject::connect(&cursor, &TimeCursor::moved, &cursor, [&] { turns += cursor.frame() == 0u; });
    cursor.play();
    EXPECT_TRUE(waitFor([&] { return turns > 1; }));
    cursor.pause();
}

TEST_F(TimeCursorTest, FollowsARunInProgressUntilTheUserStepsBack) {
    TimeCursor cursor;
    const auto run = tenFrames();
    cursor.setRun(run, true);
    EXPECT_TRUE(cursor.isLive());
    LiveBatch more;
    more.newest.frame = std::make_shared<const Frame>(test::frameOf(run->scene(), 0.1, 1.0));
    run->append(std::move(more));
    cursor.grown();
    EXPECT_EQ(cursor.frame(), std::nullopt);  // between stored frames
    EXPECT_DOUBLE_EQ(cursor.head().time, 1.0);
    ASSERT_TRUE(cursor.moment());
    cursor.toggleBookmark();  // at the last that is stored
    cursor.toggleCursorB();
    EXPECT_TRUE(cursor.bookmarks().contains(9));
    EXPECT_EQ(cursor.cursorB(), 9u);
    cursor.toggleCursorB();
    EXPECT_EQ(cursor.cursorB(), std::nullopt);
    cursor.playOrPause();
    EXPECT_FALSE(cursor.isLive());
    EXPECT_EQ(cursor.frame(), 9u);
    cursor.goLive();
    EXPECT_EQ(cursor.frame(), std::nullopt);
    cursor.step(-1);
    EXPECT_FALSE(cursor.isLive());
    EXPECT_EQ(cursor.frame(), 9u);
    LiveBatch frame;
    frame.frames.push_back({1, 1.5, 30, {}});
    run->append(std::move(frame));
    cursor.grown();
    EXPECT_EQ(cursor.frame(), 9u);  // stays where it was put
    cursor.end();
    EXPECT_TRUE(cursor.isLive());
    cursor.ranOut();
    EXPECT_FALSE(cursor.isLive());
    EXPECT_EQ(cursor.frame(), 10u);
}

}  // namespace
}  // namespace keyblock
