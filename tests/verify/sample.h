// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sample, and the numbers that it says are expected.
#pragma once

#include "solver/files/scene/scene_file.h"

#include <gtest/gtest.h>

#include <string>

namespace keyblock::test {

inline Scene sample(const std::string& name) {
    const SceneReading reading = readSceneFile(std::string(KEYBLOCK_SAMPLES_DIR) + "/" + name + ".json");
    EXPECT_TRUE(reading.scene) << name;
    return reading.scene.value_or(Scene{});
}

inline double expectedOf(const Scene& scene, const std::string& quantity) {
    for (const Expected& expected : scene.about.expected)
        if (expected.quantity == quantity) return expected.value;
    ADD_FAILURE() << "no " << quantity;
    return 0.0;
}

}  // namespace keyblock::test
