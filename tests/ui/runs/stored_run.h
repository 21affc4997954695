// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sample that was run into a store, for tests that read its frames.
#pragma once

#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "ui/runs/live_run.h"

#include <gtest/gtest.h>

namespace keyblock::test {

inline Scene sample(const std::string& name) {
    const SceneReading reading = readSceneFile(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / name);
    EXPECT_TRUE(reading.scene);
    return reading.scene.value();
}

inline std::shared_ptr<LiveRun> storedRun(const Scene& scene, const std::filesystem::path& store) {
    RunStoreWriter writer(store, false);
    Control control;
    run(scene, writer, control);
    writer.close();
    return LiveRun::opened(store);
}

/// The sample slides for this time [s], with a frame every tenth of it.
inline std::shared_ptr<LiveRun> slidingRun(const std::filesystem::path& store, double duration) {
    Scene scene = sample("incline.json");
    scene.stages.front().duration = duration;
    scene.output.every = 0.1 * duration;
    return storedRun(scene, store);
}

}  // namespace keyblock::test
