// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the docks show of a run, and where clicks on them lead.
#include "tests/ui/bricks.h"
#include "tests/ui/screen/screen.h"
#include "ui/docks/event_marks.h"
#include "ui/docks/events_list.h"
#include "ui/docks/health_strip.h"
#include "ui/docks/run_warning.h"
#include "ui/docks/time_line.h"
#include "ui/docks/time_track.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/run_commands.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

namespace keyblock {
namespace {

Event eventOf(int stage, double time, EventKind kind, int bolt = -1, int block = -1) {
    Event event;
    event.stage = stage;
    event.time = time;
    event.kind = kind;
    event.bolt = bolt;
    event.block = block;
    return event;
}

/// One dynamic stage of 1 s, eleven frames, some events.
std::shared_ptr<LiveRun> elevenFrames() {
    Scene scene = test::bricks();
    scene.stages.front().duration = 1.0;
    auto run = std::make_shared<LiveRun>("nowhere.kbrun",
                                         LiveStart{std::make_shared<const Scene>(scene), HistoryColumns{}});
    LiveBatch batch;
    batch.stagesBegun = {0};
    for (int i = 0; i <= 10; ++i) batch.frames.push_back({0, 0.1 * i, i, {}});
    batch.events = {eventOf(0, 0.15, EventKind::JointSlip, -1, 1), eventOf(0, 0.45, EventKind::Debonding, 0),
                    eventOf(0, 0.75, EventKind::PlateLoss, 0)};
    batch.events[2].cause = 1;
    test::countEvents(batch.events, batch.frames);
    run->append(std::move(batch));
    return run;
}

TEST(TimeTrack, ThousandsOfEventsAreThinnedAndTheMostSevereStay) {
    std::vector<Event> events;
    std::vector<double> places;
    for (int i = 0; i < 5000; ++i) {
        events.push_back(eventOf(0, 0.0, i == 2500 ? EventKind::ShearRupture : i % 50 ? EventKind::JointSlip
                                                                                      : EventKind::Debonding));
        places.push_back(0.2 * i);
    }
    events.push_back(eventOf(0, 0.0, EventKind::BlockFalls));
    places.push_back(std::nan(""));  // hidden
    const std::vector<PlacedEvent> placed = placedEvents(events, places, 10.0);
    EXPECT_GT(placed.size(), 50u);
    bool rupture = false;
    int counted = 0;
    for (const PlacedEvent& mark : placed) counted += mark.count;
    EXPECT_EQ(counted, 5000);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        EXPECT_TRUE(i == 0 || placed[i].x - placed[i - 1].x >= 10.0);
        rupture = rupture || placed[i].event == 2500;
        EXPECT_NE(placed[i].group, EventGroup::Falls);
    }
    EXPECT_TRUE(rupture);
}

TEST(TimeTrack, AShortStageHasNoTicksIfOnlyItsZeroFits) {
    Scene scene;
    scene.stages.resize(3);
    const std::vector<TimeAxis::Span> spans = TimeAxis(scene).spans();
    EXPECT_TRUE(ticksOfStage(spans[0], 60.0).values.empty());
    EXPECT_EQ(ticksOfStage(spans[0], 200.0).values, (std::vector<double>{0.0, 0.5}));
    EXPECT_EQ(ticksOfStage(spans[2], 60.0).values, (std::vector<double>{0.0, 1.0}));  // the last stage shows its end
}

TEST(TimeAxis, GivesDynamicStagesMoreRoomAndInvertsExactly) {
    Scene scene;
    scene.stages.resize(2);
    scene.stages[1].kind = StageKind::Dynamic;
    scene.stages[1].duration = 0.5;
    const TimeAxis axis(scene);
    EXPECT_DOUBLE_EQ(axis.at(0, 1.0), 0.25);
    EXPECT_DOUBLE_EQ(axis.at(1, 0.25), 0.625);
    for (const double place : {0.0, 0.1, 0.3, 0.9, 1.0}) {
        const TimeAxis::Moment moment = axis.momentAt(place);
        EXPECT_NEAR(axis.at(moment.stage, moment.time), place, 1e-12);
    }
    EXPECT_DOUBLE_EQ(axis.at(7, 0.0), 1.0);
    EXPECT_EQ(axis.momentAt(-1.0).time, 0.0);
    EXPECT_TRUE(TimeAxis(Scene{}).isEmpty());
}

TEST(HealthRows, ShowTheWorstStepAndItsBlock) {
    const auto run = elevenFrames();
    EXPECT_EQ(healthAt(*run, 0, 1.0)[0].state, HealthState::Unknown);  // the steps were not sampled
    const auto add = [&](double time, int passes, double depth, int block) {
        LiveBatch batch;
        HealthSample sample;
        sample.time = time;
        sample.steps = static_cast<long>(100.0 * time);
        sample.worst = {passes, block, 1e-9, depth, block};
        batch.health = sample;
        run->append(std::move(batch));
    };
    add(0.2, 3, 1e-6, 0);
    add(0.4, 38, 2e-3, 2);
    const HealthRows before = healthAt(*run, 0, 0.3), after = healthAt(*run, 0, 0.5);
    EXPECT_EQ(before[0].state, HealthState::Good);
    EXPECT_EQ(after[0].state, HealthState::Warning);
    EXPECT_EQ(after[0].block, 2);
    EXPECT_EQ(after[2].state, HealthState::Bad);
    EXPECT_EQ(after[2].value, 2e-3);
    EXPECT_EQ(after[2].course.size(), 2u);
}

TEST(HealthRows, AValueThatIsNotANumberIsBad) {
    const auto run = elevenFrames();
    LiveBatch batch;
    HealthSample sample;
    sample.time = 0.2;
    sample.worst.residual = sample.worst.penetrationRatio = std::nan("");
    batch.health = sample;
    run->append(std::move(batch));
    const HealthRows rows = healthAt(*run, 0, 0.3);
    EXPECT_EQ(rows[2].state, HealthState::Bad);
    EXPECT_EQ(rows[4].state, HealthState::Bad);
}

TEST(HealthRows, SubdividedStepsAreNotAnError) {
    const auto run = elevenFrames();
    LiveBatch batch;
    HealthSample sample;
    sample.time = 0.2;
    sample.steps = sample.stepCuts = 100;
    batch.health = sample;
    run->append(std::move(batch));
    const HealthRows rows = healthAt(*run, 0, 0.3);
    EXPECT_EQ(rows[1].value, 100.0);
    EXPECT_EQ(rows[1].state, HealthState::Warning);
}

TEST(LiveRunHealth, StaysSmallHoweverLongTheRun) {
    const auto run = elevenFrames();
    for (int i = 0; i < 20000; ++i) {
        LiveBatch batch;
        HealthSample sample;
        sample.time = 1e-5 * i;
        sample.worst.passes = i == 12345 ? 33 : 2;
        batch.health = sample;
        run->append(std::move(batch));
    }
    EXPECT_LE(run->health().size(), 400u);
    int most = 0;
    for (const HealthSample& sample : run->health()) most = std::max(most, sample.worst.passes);
    EXPECT_EQ(most, 33);
}

class DocksTest : public ::testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }
};

TEST_F(DocksTest, AWarningShowsWhyResultsAreUnreliable) {
    const Themes themes;
    TimeCursor cursor;
    RunWarning line(themes, cursor);
    EXPECT_TRUE(line.isHidden());
    const auto run = elevenFrames();
    cursor.setRun(run, false);
    EXPECT_TRUE(line.isHidden());
    LiveBatch batch;
    StageResult result;
    result.outcome = Outcome::Duration;
    result.health.balanceError = 0.76;
    batch.stagesEnded = {result};
    run->append(std::move(batch));
    cursor.ranOut();
    cursor.goTo(std::size_t{3});
    EXPECT_FALSE(line.isHidden());
    EXPECT_TRUE(line.text().startsWith("Warning: energy balance error of 76 %")) << line.text().toStdString();
    line.setOn(false);
    EXPECT_TRUE(line.isHidden());
}

TEST_F(DocksTest, AClickOnAnEventGoesToItsTimeAndSelectsItsBolt) {
    Themes themes;
    TimeCursor cursor;
    Selection selection;
    Display display;
    Document document;
    BoltChoice choice(document, selection, cursor);
    document.startNew(test::bricks());
    EventsList list(themes, display, cursor, choice);
    list.resize(500, 200);
    list.show();
    cursor.setRun(elevenFrames(), false);
    auto* view = list.findChild<QTreeView*>("events");
    ASSERT_EQ(view->model()->rowCount(), 3);
    EXPECT_EQ(list.count(), 3u);
    const QRect cell = view->visualRect(view->model()->index(1, EventsModel::What));
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, cell.center());
    EXPECT_EQ(cursor.frame(), 5u);
    EXPECT_EQ(selection.pointers(), QStringList{"/bolts/0"});
    int asked = -1;
    QObject::connect(&list, &EventsList::blockAsked, &list, [&](int block) { asked = block; });
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                      view->visualRect(view->model()->index(0, EventsModel::What)).center());
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(cursor.frame(), 2u);
    cursor.goTo(6);  // the list follows
    EXPECT_EQ(view->currentIndex().row(), 1);
    cursor.goTo(0);
    EXPECT_FALSE(view->currentIndex().isValid());
    cursor.goTo(2);
    const QString chain = view->model()->index(2, 0).data(Qt::ToolTipRole).toString();
    EXPECT_TRUE(chain.contains("debonding") && chain.contains("plate loss") && chain.startsWith("load"))
        << chain.toStdString();
    cursor.setHidden(EventKind::Debonding, true);
    EXPECT_EQ(view->model()->rowCount(), 2);
}

TEST_F(DocksTest, ColumnsOfEventsShareANarrowWidth) {
    Themes themes;
    TimeCursor cursor;
    Selection selection;
    Display display;
    Document document;
    BoltChoice choice(document, selection, cursor);
    EventsList list(themes, display, cursor, choice);
    list.resize(320, 200);
    list.show();
    cursor.setRun(elevenFrames(), false);
    settle();
    const auto* view = list.findChild<QTreeView*>("events");
    EXPECT_LE(view->header()->length(), view->viewport()->width());
    for (const auto column : {EventsModel::Time, EventsModel::What, EventsModel::Where})
        EXPECT_GE(view->columnWidth(column), 50);
    const QModelIndex where = view->model()->index(0, EventsModel::Where);
    EXPECT_TRUE(where.data(Qt::ToolTipRole).toString().contains(where.data().toString()));
}

TEST_F(DocksTest, EventsAreShownByTheirTitles) {
    for (const EventGroupRow& group : eventGroups) EXPECT_EQ(nameOf(group.group).toStdString(), group.title);
    for (const EventKindRow& kind : eventKinds) EXPECT_EQ(nameOf(kind.kind).toStdString(), kind.title);
    TimeCursor cursor;
    cursor.setRun(elevenFrames(), false);
    Themes themes;
    Display display;
    EventsModel model(themes, display, cursor);
    model.takeRun();
    for (int row = 0; row < model.rowCount(); ++row) {
        const EventKind kind = cursor.run()->eventList()[model.eventAt(row)].kind;
        EXPECT_EQ(model.index(row, EventsModel::What).data().toString().toStdString(), rowOf(kind).title);
    }
    EXPECT_EQ(model.index(0, EventsModel::What).data().toString().toStdString(), "joint slip");
}

TEST_F(DocksTest, TheTimelineScrubsZoomsAndCounts) {
    Themes themes;
    Commands commands(themes);
    TimeCursor cursor;
    Selection selection;
    Display display;
    Document document;
    Runs runs(document, cursor);
    addRunCommands(commands, runs);
    addTimeCommands(commands, cursor);
    BoltChoice choice(document, selection, cursor);
    TimeLine line(themes, display, commands, cursor, choice);
    line.resize(1200, 104);
    line.show();
    EXPECT_EQ(line.height(), 30);  // no run yet
    const auto* hint = line.findChild<QLabel*>("timeLineHint");
    EXPECT_TRUE(hint->text().contains("Press F5")) << hint->text().toStdString();
    commands.setKeys("run.start", {QKeySequence("F4")});
    EXPECT_TRUE(hint->text().contains("Press F4")) << hint->text().toStdString();
    commands.setKeys("run.start", {});
    cursor.setRun(elevenFrames(), false);
    EXPECT_EQ(line.height(), 104);
    line.resize(1200, 104);
    QCoreApplication::processEvents();
    auto* track = line.findChild<TimeTrack*>("timeTrack");
    QTest::mouseClick(track, Qt::LeftButton, {}, {track->width() / 2 + 8, 50});
    EXPECT_EQ(cursor.frame(), 5u);
    EXPECT_TRUE(line.findChild<QLabel*>("timeFrame")->text().contains("6"));
    QTest::mouseClick(track, Qt::LeftButton, Qt::ControlModifier, {20, 50});
    EXPECT_EQ(cursor.cursorB(), 0u);
    EXPECT_EQ(cursor.frame(), 5u);
    auto* slip = line.findChild<QToolButton*>("count0");
    EXPECT_TRUE(slip->text().endsWith("1")) << slip->text().toStdString();
    QTest::mouseClick(slip, Qt::LeftButton);
    EXPECT_TRUE(cursor.hiddenKinds().contains(EventKind::JointSlip));
    EXPECT_FALSE(line.findChild<QToolButton*>("count3")->isEnabled());  // nothing yielded
    auto* next = line.findChild<QToolButton*>("nextEvent");
    EXPECT_EQ(next->isEnabled(), commands.action("time.nextEvent")->isEnabled());
    EXPECT_TRUE(next->text().endsWith("N")) << next->text().toStdString();
    cursor.end();
    EXPECT_FALSE(next->isEnabled());
    cursor.setRun(nullptr, false);
    EXPECT_EQ(line.height(), 30);
    QTest::mouseClick(track, Qt::LeftButton, {}, {300, 50});
}

TEST(BoltChoice, ChoosingABoltOfAPatternSelectsThePattern) {
    Scene scene = test::bricks();
    scene.boltPatterns.resize(1);
    scene.boltPatterns[0].name = "roof";
    scene.bolts.push_back(scene.bolts.front());
    scene.bolts.back().name = "roof.1";
    Selection selection;
    TimeCursor cursor;
    Document document;
    BoltChoice choice(document, selection, cursor);
    document.startNew(scene);
    choice.choose(1);  // without a run
    EXPECT_EQ(choice.bolt(), -1);
    cursor.setRun(std::make_shared<LiveRun>("nowhere.kbrun", LiveStart{std::make_shared<const Scene>(scene), {}}), false);
    choice.choose(1);
    EXPECT_EQ(choice.bolt(), 1);
    EXPECT_EQ(selection.pointers(), QStringList{"/bolt_patterns/0"});
    selection.set({"/bolts/0"});
    EXPECT_EQ(choice.bolt(), 0);
    selection.set({"/bolts/77", "/bolts/x", "/materials/rock"});
    EXPECT_EQ(choice.bolt(), -1);
    choice.choose(99);
    EXPECT_EQ(choice.bolt(), -1);
}

TEST(BoltChoice, MatchesBoltsByNameAfterTheSceneWasEdited) {
    Scene ran = test::bricks();
    ran.bolts.push_back(ran.bolts.front());
    ran.bolts.back().name = "C";
    Scene drawn = ran;
    drawn.bolts.erase(drawn.bolts.begin());  // C is the first now
    Document document;
    document.startNew(drawn);
    Selection selection;
    TimeCursor cursor;
    BoltChoice choice(document, selection, cursor);
    cursor.setRun(std::make_shared<LiveRun>("nowhere.kbrun", LiveStart{std::make_shared<const Scene>(ran), {}}), false);
    selection.set({"/bolts/0"});
    EXPECT_EQ(choice.bolt(), 1);
    choice.choose(0);  // B is not in the document any more
    EXPECT_EQ(choice.bolt(), 0);
    EXPECT_TRUE(selection.isEmpty());
    choice.choose(1);
    EXPECT_EQ(selection.pointers(), QStringList{"/bolts/0"});
}

}  // namespace
}  // namespace keyblock
