// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The slope whose factor of safety is known, from its file to the factor.
#include "solver/files/scene/scene_file.h"
#include "solver/run/safety.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

/// Plane sliding without cohesion: F = tan φ / tan α = 1.428.
TEST(SafetySample, TheSlopeHasTheFactorOfPlaneSliding) {
    const SceneReading reading = readSceneFile(std::string(KEYBLOCK_SAMPLES_DIR) + "/slope-safety.json");
    ASSERT_TRUE(reading.scene);
    Control control;
    const auto trial = [&](const Scene& reduced, double, Sink& sink) { run(reduced, sink, control); };
    const SafetyFactor found = findSafetyFactor(*reading.scene, trial);
    ASSERT_TRUE(found.lower && found.upper);
    const double expected = 1.0 / std::tan(35.0 * std::numbers::pi / 180.0);
    EXPECT_LE(*found.upper - *found.lower, 0.01);
    EXPECT_LE(*found.lower, expected * (1.0 + 1e-3));
    EXPECT_GE(*found.upper, expected * (1.0 - 1e-3));
    ASSERT_TRUE(found.mode && found.mode->blocks.size() == 1u);
    const Point way = found.mode->blocks[0].displacement.normalized();
    EXPECT_EQ(found.mode->blocks[0].movement, Movement::Slides);
    EXPECT_NEAR(way.y() / way.x(), std::tan(35.0 * std::numbers::pi / 180.0), 0.05);
}

}  // namespace
}  // namespace keyblock
