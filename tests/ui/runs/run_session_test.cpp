// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run in the window gives the results of a run from the command line, can be paused,
// stopped and resumed, and ends with a message after any error.
#include "ui/runs/run_session.h"

#include "solver/files/read_error.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/scene/scene_file.h"
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"
#include "tests/wait_for.h"
#include "ui/runs/live_run.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

SceneReading sample(const std::string& name) {
    SceneReading reading = readSceneFile(fs::path(KEYBLOCK_SAMPLES_DIR) / (name + ".json"));
    EXPECT_TRUE(reading.scene) << name;
    return reading;
}

RunOrder orderOf(const SceneReading& reading, const fs::path& store) {
    RunOrder order;
    order.scene = std::make_shared<const Scene>(*reading.scene);
    if (reading.cut) order.cut = std::make_shared<const SceneCut>(*reading.cut);
    order.store = store;
    return order;
}

/// The store of a run without a window.
Results plainRun(const Scene& scene, const fs::path& store) {
    RunStoreWriter writer(store, false);
    Control control;
    run(scene, writer, control);
    writer.close();
    return readResults(RunStore(store));
}

bool finishes(RunSession& session) {
    return waitFor([&] { return session.isOver(); }, 120000);
}

/// The step of a paused run once a requested step is taken. States between stored frames are handed over between two
/// steps only: the first two may precede the requested step, the third one follows it, and a run that did not pause
/// would take another step before the fourth.
long stepAtRest(const RunSession& session) {
    const auto newest = [&] { return session.run()->newest(); };
    for (int look = 0; look < 4; ++look) {
        const auto before = newest().frame;
        EXPECT_TRUE(waitFor([&] { return newest().frame != before && !newest().stored; }));
    }
    return newest().frame ? newest().frame->step : -1;
}

/// A block that stays at rest for more steps than a test takes.
SceneReading endless() {
    SceneReading reading = sample("incline");
    for (auto& [name, joint] : reading.scene->jointMaterials) joint.frictionAngle = 60.0;
    reading.scene->stages[0].duration = 1e4;
    return reading;
}

class RunSessionTest : public ::testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }
    fs::path path(const std::string& name) const { return folder_.path() / name; }
    test::ScratchFolder folder_;
};

TEST_F(RunSessionTest, GivesTheSameResultsAsARunWithoutAWindow) {
    for (const std::string name : {"rebar-20", "incline"}) {
        const SceneReading reading = sample(name);
        const Results plain = plainRun(*reading.scene, path(name + "-plain.kbrun"));
        RunSession session(orderOf(reading, path(name + "-1.kbrun")));
        session.start();
        ASSERT_TRUE(finishes(session)) << name;
        EXPECT_FALSE(session.failed()) << session.message().toStdString();
        EXPECT_EQ(session.fraction(), 1.0);
        EXPECT_TRUE(readResults(RunStore(path(name + "-1.kbrun"))) == plain) << name;
    }
}

TEST_F(RunSessionTest, KnowsWhetherTheRockIsStable) {
    for (const auto& [name, unstable] : {std::pair{"burst-rebar", true}, std::pair{"rebar-20", false}}) {
        RunSession session(orderOf(sample(name), path(std::string(name) + ".kbrun")));
        EXPECT_FALSE(session.isUnstable()) << name;
        session.start();
        ASSERT_TRUE(finishes(session)) << name;
        EXPECT_FALSE(session.failed()) << name;
        EXPECT_EQ(session.isUnstable(), unstable) << name << ": " << session.message().toStdString();
    }
}

TEST_F(RunSessionTest, TheWindowGetsTheSameDataAsTheStore) {
    RunSession session(orderOf(sample("rebar-20"), path("a.kbrun")));
    session.start();
    ASSERT_TRUE(finishes(session));
    const RunStore store(path("a.kbrun"));
    const LiveRun& live = *session.run();
    EXPECT_EQ(live.events(), store.events());
    EXPECT_EQ(live.history(), store.history());
    EXPECT_EQ(live.columns(), store.columns());
    EXPECT_EQ(live.blockNames(), store.blockNames());
    ASSERT_EQ(live.frames().size(), store.frames().size());
    for (std::size_t i = 0; i < store.frames().size(); ++i) EXPECT_TRUE(live.frame(i) == store.frame(i)) << i;
    ASSERT_EQ(live.stages().size(), store.stages().size());
    for (std::size_t i = 0; i < live.stages().size(); ++i)
        EXPECT_EQ(live.stages()[i].result, store.stages()[i].result);
    const auto opened = LiveRun::opened(path("a.kbrun"));
    EXPECT_EQ(opened->events(), store.events());
    EXPECT_TRUE(opened->frame(3) == store.frame(3));
}

TEST_F(RunSessionTest, StoppedAndResumedEndsWithTheSameResults) {
    const SceneReading reading = sample("rebar-20");
    const Results plain = plainRun(*reading.scene, path("plain.kbrun"));
    bool stopped = false;
    {
        RunSession session(orderOf(reading, path("b.kbrun")));
        QObject::connect(&session, &RunSession::advanced, &session, [&] {
            if (session.run()->frames().size() > 5) session.stop();
        });
        session.start();
        ASSERT_TRUE(finishes(session));
        stopped = session.outcome() == Outcome::Stopped;
        EXPECT_EQ(stopped, session.message().contains("b.kbrun")) << session.message().toStdString();
    }
    RunOrder order = orderOf(reading, path("b.kbrun"));
    order.resume = true;
    RunSession session(order);
    session.start();
    ASSERT_TRUE(finishes(session));
    EXPECT_FALSE(session.failed()) << session.message().toStdString();
    EXPECT_TRUE(readResults(RunStore(path("b.kbrun"))) == plain);
    if (!stopped) return;
    EXPECT_EQ(session.run()->events(), plain.events);
    EXPECT_EQ(session.run()->history(), plain.history);
    EXPECT_EQ(session.run()->frames().size(), plain.frames.size());
}

TEST_F(RunSessionTest, SingleStepWhilePausedRunsOneStep) {
    RunSession session(orderOf(endless(), path("c.kbrun")));
    session.start();
    ASSERT_TRUE(waitFor([&] { return session.steps() > 3; }, 60000));
    session.pause();
    EXPECT_EQ(session.state(), RunSession::State::Paused);
    const long from = stepAtRest(session);
    ASSERT_GE(from, 0);
    session.step();
    const long next = stepAtRest(session);
    EXPECT_EQ(next, from + 1);
    session.goOn();
    EXPECT_EQ(session.state(), RunSession::State::Running);
    EXPECT_TRUE(waitFor([&] { return session.run()->newest().frame->step > next || session.isOver(); }, 60000));
    session.stop();
    ASSERT_TRUE(finishes(session));
}

TEST_F(RunSessionTest, ASceneThatCannotRunEndsWithAMessage) {
    SceneReading reading = sample("incline");
    reading.scene->stages.clear();
    RunSession session(orderOf(reading, path("d.kbrun")));
    session.start();
    ASSERT_TRUE(finishes(session));
    EXPECT_TRUE(session.failed());
    EXPECT_TRUE(session.message().contains("no stages")) << session.message().toStdString();
    SceneReading broken = sample("incline");
    broken.scene->materials.clear();
    RunSession other(orderOf(broken, path("e.kbrun")));
    other.start();
    ASSERT_TRUE(finishes(other));
    EXPECT_TRUE(other.failed());
    EXPECT_TRUE(other.message().contains("/")) << other.message().toStdString();
    EXPECT_FALSE(fs::exists(path("e.kbrun")));
}

TEST_F(RunSessionTest, AStoreThatCannotBeWrittenEndsWithAMessage) {
    for (const char* store : {"/dev/full", "/proc/no-such-place/a.kbrun"}) {
        RunSession session(orderOf(sample("incline"), store));
        session.start();
        ASSERT_TRUE(finishes(session)) << store;
        EXPECT_TRUE(session.failed()) << store;
        EXPECT_TRUE(session.message().contains(store)) << session.message().toStdString();
    }
}

TEST_F(RunSessionTest, DestroyingTheSessionStopsTheRunAndKeepsItsStore) {
    {
        RunSession session(orderOf(sample("drift-bolted"), path("f.kbrun")));
        session.start();
        ASSERT_TRUE(waitFor([&] { return session.run() && !session.run()->frames().empty(); }, 60000));
    }
    EXPECT_FALSE(RunStore(path("f.kbrun")).frames().empty());
}

TEST_F(RunSessionTest, AWindowThatHangsMissesNoData) {
    RunSession session(orderOf(sample("rebar-20"), path("g.kbrun")));
    session.start();
    const auto isWritten = [&] {
        try {
            return isFinished(RunStore(path("g.kbrun")));
        } catch (const CannotRead&) {  // it does not exist yet
            return false;
        }
    };
    ASSERT_TRUE(test::waitFor(isWritten));  // handles no events
    ASSERT_TRUE(finishes(session));
    EXPECT_TRUE(session.run()->newest().frame);
    EXPECT_EQ(session.run()->frames().size(), RunStore(path("g.kbrun")).frames().size());
}

}  // namespace
}  // namespace keyblock
