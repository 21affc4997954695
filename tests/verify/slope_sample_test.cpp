// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shaken slope against Newmark's sliding block, which is integrated here from
// the record alone. A slip lasts 0.45 s; a step of 1 ms too much or too little at
// either end, where the blocks hardly move, is 0.5 % of it, so that is the tolerance.
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace keyblock {
namespace {

constexpr double slopeGravity = 9.81;  // [m/s²]
constexpr double dip = 35.0 * std::numbers::pi / 180.0;
constexpr double tolerance = 0.005;

Scene slope() {
    const SceneReading reading = readSceneFile(std::string(KEYBLOCK_SAMPLES_DIR) + "/slope-shaken.json");
    EXPECT_TRUE(reading.scene);
    return reading.scene.value_or(Scene{});
}

/// Between its rows straight lines, nothing outside them.
double recordAt(const Table& record, double time) {
    const auto after = std::upper_bound(record.begin(), record.end(), time,
                                        [](double t, const auto& row) { return t < row.first; });
    if (after == record.begin() || after == record.end()) return 0.0;
    const auto before = after - 1;
    return before->second +
           (after->second - before->second) * (time - before->first) / (after->first - before->first);
}

/// Way down the bedding of a rigid block by the ends of steps of 10 µs [m]; it slides down or stands.
class SlidingBlock {
public:
    SlidingBlock(const Table& record, double factor, double frictionAngle)
        : record_(record), factor_(factor), friction_(std::tan(frictionAngle * std::numbers::pi / 180.0)) {}

    /// \pre `time` is not before that of the last call.
    double at(double time) {
        for (; time_ + 0.5 * step_ < time; time_ += step_) {
            // the ground goes to the right under a row above zero, so the block is pushed to the left, down the slope,
            // by one below zero
            const double push = -factor_ * recordAt(record_, time_ + 0.5 * step_);
            const double along = slopeGravity * std::sin(dip) + push * std::cos(dip);
            const double across = slopeGravity * std::cos(dip) - push * std::sin(dip);
            const double speed = std::max(speed_ + (along - friction_ * across) * step_, 0.0);
            way_ += 0.5 * (speed_ + speed) * step_;
            speed_ = speed;
        }
        return way_;
    }

private:
    static constexpr double step_ = 1e-5;  // [s]
    const Table& record_;
    double factor_, friction_;
    double time_ = 0.0, speed_ = 0.0, way_ = 0.0;
};

class ShakenSlope : public testing::TestWithParam<double> {};

TEST_P(ShakenSlope, FollowsASlidingBlock) {
    Scene scene = slope();
    scene.jointMaterials.front().second.frictionAngle = GetParam();
    const Acceleration& shaking = *scene.stages.front().baseAcceleration;
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.back().outcome, Outcome::Duration);
    SlidingBlock block(shaking.record, shaking.factor, GetParam()), whole = block;
    const double all = whole.at(scene.stages.front().duration);
    ASSERT_GT(results.history.size(), 100u);
    for (const HistoryRow& row : results.history) {
        const double way = block.at(row.time);
        for (std::size_t monitor = 0; monitor < 2; ++monitor) {
            EXPECT_NEAR(row.values[2 * monitor], -way * std::cos(dip), tolerance * all) << row.time;
            EXPECT_NEAR(row.values[2 * monitor + 1], -way * std::sin(dip), tolerance * all) << row.time;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(FrictionAngles, ShakenSlope, testing::Values(38.0, 40.0, 42.0));

TEST(ShakenSlopeSample, NamesWhatASlidingBlockDoes) {
    const Scene scene = slope();
    const Acceleration& shaking = *scene.stages.front().baseAcceleration;
    SlidingBlock block(shaking.record, shaking.factor, scene.jointMaterials.front().second.frictionAngle);
    const double way = block.at(scene.stages.front().duration);
    for (const Expected& expected : scene.about.expected)
        EXPECT_NEAR(expected.value, -way * (expected.quantity.ends_with("x") ? std::cos(dip) : std::sin(dip)), 2e-6);
}

}  // namespace
}  // namespace keyblock
