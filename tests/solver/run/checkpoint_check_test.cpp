// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run refuses a checkpoint with wrong indices, lists or numbers, and takes every one
// that it has made itself. `make mutations` changes two thousand at random under the
// address sanitizer; the suite two hundred. KEYBLOCK_MUTATIONS sets their number,
// KEYBLOCK_SEED which.
#include "solver/run/checkpoint_check.h"

#include "solver/engine/setup/make_model.h"
#include "tests/solver/run/checkpoint_scenes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace keyblock {
namespace {

using test::runKept;

/// A run that is in the middle of a stage, with its model.
struct Halfway {
    explicit Halfway(const Scene& given) : scene(given), model(makeModel(scene)) {
        for (const std::string& bytes : runKept(scene).kept)
            if (const Checkpoint one = checkpointOf(bytes).value(); one.begun && !checkpoint.begun) checkpoint = one;
    }

    /// What does not fit after a change; empty if all of it fits.
    std::string misfitAfter(const std::function<void(Checkpoint&)>& change) const {
        Checkpoint changed = checkpoint;
        change(changed);
        return misfitOf(changed, model, scene).value_or("");
    }

    Scene scene;
    Model model;
    Checkpoint checkpoint;
};

TEST(CheckpointCheck, NamesWhatDoesNotFit) {
    const Halfway run(test::tearing());
    ASSERT_TRUE(run.checkpoint.begun);
    ASSERT_FALSE(run.checkpoint.state.contacts.empty());
    EXPECT_EQ(run.misfitAfter([](Checkpoint&) {}), "");
    const int wild = std::numeric_limits<int>::max();
    EXPECT_EQ(run.misfitAfter([&](Checkpoint& c) { c.state.contacts[0].blockB = wild; }), "blockB");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.state.contacts[0].corner = -1; }), "corner");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.state.contacts[0].joint = 99; }), "joint");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.state.bolts[0].nodes[3].slot = 99; }), "nodes");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.state.bolts[0].slots[0].block = -1; }), "block");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.state.blocks[1].corners.pop_back(); }), "blocks");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.state.blocks[1].rest.quietSteps = -1; }), "quietSteps");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.state.acceleration.resize(5); }), "acceleration");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.blockExtremes.clear(); }), "blockExtremes");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.watch.slipped.insert({0, 7}); }), "slipped");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.watch.closed.push_back({.blocks = {0, 7}}); }), "closed");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) {
        for (int twice = 0; twice < 2; ++twice) c.watch.closed.push_back({.blocks = {0, 1}, .bodies = {0, 1}});
    }),
              "closed");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.pace.sweepsFirst.pause = -1; }), "pause");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.loads.motionSources[0].row = 3; }), "motionSources");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.start.joined.push_back({-1, 0}); }), "joined");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.stage = 1; }), "stage");
    EXPECT_EQ(run.misfitAfter([](Checkpoint& c) { c.written.events = -1; }), "events");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(run.misfitAfter([&](Checkpoint& c) { c.state.blocks[0].centroid.y() = nan; }), "");
    EXPECT_NE(run.misfitAfter([&](Checkpoint& c) { c.pace.dt = -std::numeric_limits<double>::infinity(); }), "");
}

TEST(CheckpointCheck, ARunWritesNothingFromACheckpointThatDoesNotFit) {
    Halfway halfway(test::tearing());
    halfway.checkpoint.increment = 1 << 20;  // beyond the last increment
    MemorySink sink;
    Control control;
    EXPECT_THROW(run(halfway.scene, sink, control, {}, &halfway.checkpoint), UnfitCheckpoint);
    EXPECT_TRUE(sink.results.columns.names.empty());
}

/// Takes all results and keeps none.
class EmptySink : public Sink {
public:
    void begin(const Scene&, const HistoryColumns&) override {}
    void stageBegins(int) override {}
    void event(const Event&) override {}
    void history(const HistoryRow&) override {}
    void frame(const Frame&) override {}
    void stageEnds(const StageResult&) override {}
};

/// True if a run takes the checkpoint; it is stopped soon after.
bool isTaken(const Scene& scene, const std::string& bytes) {
    const std::optional<Checkpoint> from = checkpointOf(bytes);
    if (!from) return false;
    EmptySink sink;
    Control control;
    int iterations = 0;
    control.progress = [&](const Progress&) { control.stop = ++iterations >= 20; };
    try {
        run(scene, sink, control, {1}, &*from);
    } catch (const UnfitCheckpoint&) {
        return false;
    }
    return true;
}

/// Overwrites a few bytes with a number that is likely to be wrong in their place.
void mutate(std::string& bytes, std::mt19937& random) {
    constexpr double huge = std::numeric_limits<double>::max(), nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> reals{nan, -nan, std::numeric_limits<double>::infinity(), huge, -1e9, 1e-300};
    const std::vector<std::int64_t> wholes{-1, 1L << 63, 0x7FFFFFFF, 0x7FF80000, 1000, 3, 1L << 31};
    const auto put = [&](const void* value, std::size_t size) {
        std::memcpy(bytes.data() + random() % (bytes.size() - size), value, size);
    };
    switch (random() % 4) {
        case 0: put(&reals[random() % reals.size()], 8); break;
        case 1: put(&wholes[random() % wholes.size()], 4); break;
        case 2: put(&wholes[random() % wholes.size()], 8); break;
        default: bytes[random() % bytes.size()] ^= static_cast<char>(1u << random() % 8); break;
    }
}

TEST(CheckpointCheck, ARunTakesOrRefusesCheckpointsChangedAtRandom) {
    const char* asked = std::getenv("KEYBLOCK_MUTATIONS");
    const char* seed = std::getenv("KEYBLOCK_SEED");
    const int count = asked ? std::atoi(asked) : 200;
    std::mt19937 random(seed ? static_cast<unsigned>(std::atoi(seed)) : 1u);
    int taken = 0;
    std::vector<Scene> scenes{test::tearing(), test::sliding(0.4), test::staged()};
    for (Scene& scene : scenes) scene.limits.wallTime = 5.0;  // a changed step may be too short for any progress
    std::vector<std::vector<std::string>> kept;
    kept.reserve(scenes.size());
    for (const Scene& scene : scenes) kept.push_back(runKept(scene).kept);
    for (int i = 0; i < count; ++i) {
        const std::size_t which = random() % scenes.size();
        std::string bytes = kept[which][random() % kept[which].size()];
        mutate(bytes, random);
        taken += isTaken(scenes[which], bytes);
    }
    RecordProperty("taken", taken);
    EXPECT_GT(taken, count / 10);
    EXPECT_LT(taken, count * 95 / 100);
    if (asked) std::cout << count << " checkpoints: " << taken << " taken, " << count - taken << " refused\n";
}

}  // namespace
}  // namespace keyblock
