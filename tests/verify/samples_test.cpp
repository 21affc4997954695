// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every sample runs to its end and gives the numbers that it says it gives.
#include "solver/files/scene/scene_file.h"
#include "solver/results/quantity.h"
#include "solver/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {
namespace {

std::vector<std::filesystem::path> samples() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(KEYBLOCK_SAMPLES_DIR))
        if (entry.path().extension() == ".json") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

std::string sampleTestName(const testing::TestParamInfo<std::filesystem::path>& sample) {
    std::string name = sample.param.stem().string();
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

class Sample : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Sample, GivesTheNumbersItNames) {
    const SceneReading reading = readSceneFile(GetParam());
    for (const Problem& problem : reading.problems) EXPECT_NE(problem.severity, Severity::Error) << problem.message;
    ASSERT_TRUE(reading.scene);
    const Scene& scene = *reading.scene;
    EXPECT_FALSE(scene.about.shows.empty());
    EXPECT_FALSE(scene.about.source.empty());
    ASSERT_FALSE(scene.about.expected.empty());
    const Scene& solved = reading.cut ? reading.cut->scene : scene;
    const Results results = runInMemory(scene);
    for (const StageResult& stage : results.stages) EXPECT_NE(stage.outcome, Outcome::Failed) << stage.message;
    for (const StageResult& stage : results.stages)
        if (stage.outcome != Outcome::Collapse) {
            EXPECT_LT(std::abs(stage.health.balanceError), 1e-2) << stage.stage;
        }
    const MemoryRun run(solved, results);
    const std::vector<StageRecord> stages = run.stages();
    const RecordedRun recorded{solved, results.history, results.events, stages};
    for (const Expected& expected : scene.about.expected) {
        const MeasuredComparison c = compare(expected, recorded);
        EXPECT_TRUE(c.within) << expected.quantity << ": measured " << c.measured.value.value_or(0.0) << " "
                              << c.measured.problem << ", expected " << expected.value;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Sample, testing::ValuesIn(samples()), sampleTestName);

}  // namespace
}  // namespace keyblock
