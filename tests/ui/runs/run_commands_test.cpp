// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_commands.h"

#include "tests/ui/bricks.h"
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"
#include "ui/document/document.h"
#include "ui/edit/defaults.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/runs/live_run.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"

#include <gtest/gtest.h>

#include <QUndoStack>

namespace keyblock {
namespace {

struct Room {
    Themes themes;
    Commands commands{themes};
    Document document;
    TimeCursor cursor;
    Runs runs{document, cursor};

    Room() {
        addRunCommands(commands, runs);
        addTimeCommands(commands, cursor);
    }
    bool isOn(const char* id) const { return commands.action(id)->isEnabled(); }
};

TEST(RunCommands, RunIsDisabledWithAReasonWhenThereIsNothingToRun) {
    NEED_SCREEN();
    Room room;
    room.document.startNew(newScene());
    EXPECT_FALSE(room.isOn("run.start"));
    EXPECT_TRUE(room.commands.action("run.start")->toolTip().contains("draw an outline or a block"));
    for (const char* id : {"run.pause", "run.step", "run.stop"}) EXPECT_FALSE(room.isOn(id)) << id;
    Scene bricks = test::bricks();
    room.document.apply("draw", bricks);
    EXPECT_TRUE(room.isOn("run.start"));
    EXPECT_FALSE(room.commands.action("run.start")->toolTip().contains("Nothing to run"));
    bricks.stages.clear();
    room.document.apply("no stages", bricks);
    EXPECT_TRUE(room.commands.action("run.start")->toolTip().contains("add a stage"));
    room.document.undo().undo();
    EXPECT_TRUE(room.isOn("run.start"));
    room.document.undo().undo();
    EXPECT_FALSE(room.isOn("run.start"));
}

TEST(RunCommands, RunIsDisabledWhileTheSceneHasErrors) {
    NEED_SCREEN();
    Room room;
    Scene scene = test::sample("suspended-block.json");
    room.document.startNew(scene);
    scene.materials.clear();
    room.document.apply("remove the materials", scene);
    ASSERT_TRUE(waitFor([&] { return !room.isOn("run.start"); }));
    EXPECT_TRUE(room.commands.action("run.start")->toolTip().contains("Fix the errors listed under Problems first"));
    room.document.undo().undo();
    EXPECT_TRUE(room.isOn("run.start"));
    ASSERT_TRUE(waitFor([&] { return room.document.checkIsCurrent(); }));
    EXPECT_TRUE(room.isOn("run.start"));
}

TEST(RunCommands, TimeCommandsAreDisabledAtTheEnds) {
    NEED_SCREEN();
    Room room;
    const auto run = std::make_shared<LiveRun>(
        "nowhere.kbrun", LiveStart{std::make_shared<const Scene>(test::bricks()), HistoryColumns{}});
    LiveBatch batch;
    batch.stagesBegun = {0};
    for (int i = 0; i < 3; ++i) batch.frames.push_back({0, 0.1 * i, i, {}});
    Event event;
    event.time = 0.1;
    event.kind = EventKind::Debonding;
    batch.events = {event};
    test::countEvents(batch.events, batch.frames);
    run->append(std::move(batch));
    for (const char* id : {"time.next", "time.previous", "time.home", "time.end", "time.nextEvent", "time.play"})
        EXPECT_FALSE(room.isOn(id)) << id;
    room.cursor.setRun(run, false);
    EXPECT_FALSE(room.isOn("time.next") || room.isOn("time.end") || room.isOn("time.nextEvent"));
    EXPECT_TRUE(room.isOn("time.previous") && room.isOn("time.home") && room.isOn("time.previousEvent"));
    room.commands.action("time.home")->trigger();
    EXPECT_TRUE(room.isOn("time.next") && room.isOn("time.end") && room.isOn("time.nextEvent"));
    EXPECT_FALSE(room.isOn("time.previous") || room.isOn("time.home") || room.isOn("time.previousEvent"));
    room.cursor.setHidden(EventKind::Debonding, true);
    EXPECT_FALSE(room.isOn("time.nextEvent"));
    room.cursor.setRun(nullptr, false);
    EXPECT_FALSE(room.isOn("time.next") || room.isOn("time.home"));
}

}  // namespace
}  // namespace keyblock
