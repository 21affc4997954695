// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Failures of bolts and the largest forces in them are in frames, not between them.
#include "solver/run/event_frames.h"

#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "solver/run/stage_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace keyblock {
namespace {

Scene cutSample(const std::string& name) {
    SceneReading reading = readSceneFile(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / (name + ".json"));
    return reading.cut ? reading.cut->scene : *reading.scene;
}

const Results& resultsOf(const std::string& name) {
    static std::map<std::string, Results> known;
    const auto [found, isNew] = known.try_emplace(name);
    if (isNew) found->second = runInMemory(cutSample(name));
    return found->second;
}

double largestAxial(const Frame& frame, std::size_t bolt) {
    double largest = 0.0;
    const auto& nodes = frame.bolts[bolt].nodes;
    for (std::size_t n = 0; n + 1 < nodes.size(); ++n) largest = std::max(largest, std::abs(nodes[n].axialForce));
    return largest;
}

class EventFramesOf : public testing::TestWithParam<const char*> {};

TEST_P(EventFramesOf, ShowThePeakOfEveryBolt) {
    const Results& results = resultsOf(GetParam());
    for (std::size_t bolt = 0; bolt < results.frames.back().extremes.size(); ++bolt) {
        double shown = 0.0;
        for (const Frame& frame : results.frames) shown = std::max(shown, largestAxial(frame, bolt));
        const double peak = std::abs(results.frames.back().extremes[bolt].axialForce.value);
        EXPECT_GE(shown, 0.995 * peak) << "bolt " << bolt;
    }
}

TEST_P(EventFramesOf, EncloseEveryFailure) {
    const Results& results = resultsOf(GetParam());
    const Scene scene = cutSample(GetParam());
    for (std::size_t i = 0; i < results.events.size(); ++i) {
        const Event& event = results.events[i];
        if (!callsForFrames(event) || isSeenAfterwards(event)) continue;
        const auto after = std::find_if(results.frames.begin(), results.frames.end(), [&](const Frame& frame) {
            return frame.events > static_cast<long>(i);
        });
        ASSERT_NE(after, results.frames.end());
        ASSERT_NE(after, results.frames.begin());
        const double shortly = 2e-3 * frameInterval(scene, scene.stages[event.stage]);
        EXPECT_EQ(std::prev(after)->stage, event.stage) << i;
        EXPECT_LE(event.time - std::prev(after)->time, shortly) << i;
    }
}

TEST_P(EventFramesOf, AreInOrderOfTimeAndCountEvents) {
    const Results& results = resultsOf(GetParam());
    for (std::size_t f = 1; f < results.frames.size(); ++f) {
        const Frame &before = results.frames[f - 1], &frame = results.frames[f];
        EXPECT_LE(std::pair(before.stage, before.time), std::pair(frame.stage, frame.time)) << f;
        EXPECT_LE(before.events, frame.events) << f;
        EXPECT_FALSE(before.time == frame.time && before.step == frame.step && before.events == frame.events) << f;
    }
    EXPECT_EQ(results.frames.back().events, static_cast<long>(results.events.size()));
}

INSTANTIATE_TEST_SUITE_P(Samples, EventFramesOf, testing::Values("burst-rebar", "drop-d-bolt", "burst-dbolt", "rebar-20"),
                         [](const auto& sampled) {
                             std::string name = sampled.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST(EventFrames, AreNoMoreThanFramesAtEqualIntervals) {
    EventFrames frames;
    frames.kept = 99;
    EXPECT_TRUE(mayKeep(frames, 100));
    frames.kept = 100;
    EXPECT_FALSE(mayKeep(frames, 100));
}

TEST(EventFrames, LeaveFramesAtEqualIntervalsWhereTheyWere) {
    Scene scene = cutSample("burst-dbolt");
    const double every = frameInterval(scene, scene.stages[0]);
    long atIntervals = 0;
    for (const Frame& frame : resultsOf("burst-dbolt").frames) {
        const double turns = frame.time / every;
        if (std::abs(turns - std::round(turns)) < 0.5) ++atIntervals;
    }
    EXPECT_GE(atIntervals, plannedFrames(scene, 0));
}

}  // namespace
}  // namespace keyblock
