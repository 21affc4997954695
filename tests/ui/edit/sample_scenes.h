// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The samples as scenes, for tests that apply to any of them.
#pragma once

#include "solver/files/scene/scene_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

inline Scene sampleScene(const std::string& name) {
    SceneReading reading = readSceneFile(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / (name + ".json"));
    EXPECT_TRUE(reading.scene) << name;
    return reading.scene ? std::move(*reading.scene) : Scene{};
}

inline std::vector<std::string> sampleNames() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(KEYBLOCK_SAMPLES_DIR))
        if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    EXPECT_GT(names.size(), 20u);
    return names;
}

}  // namespace keyblock
