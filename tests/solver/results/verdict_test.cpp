// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/verdict.h"

#include "tests/solver/results/sample_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock::test {
namespace {

TEST(StageWarnings, AreForPoorEnergyBalanceAndUnbalancedBlocks) {
    const Scene scene = sampleScene();
    Results results = sampleResults();
    for (StageResult& stage : results.stages) {
        stage.health.balanceError = 1e-3;
        stage.health.worst = {0, 5e-4, 1.0};
    }
    EXPECT_TRUE(stageWarnings(MemoryRun(scene, results)).empty());
    results.stages[0].health.balanceError = -0.762;
    results.stages[0].health.worst = {0, 4e-3, 100.0};
    const std::vector<StageWarning> warnings = stageWarnings(MemoryRun(scene, results));
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0].stage, results.stages[0].stage);
    EXPECT_EQ(warnings[0].text.rfind("block left has 0.4 % of its weight unbalanced in stage '", 0), 0U)
        << warnings[0].text;
    EXPECT_EQ(warnings[1].text.rfind("energy balance error of 76.2 % in stage '", 0), 0U) << warnings[1].text;
}

TEST(StageWarnings, AnEnergyBalanceThatIsNotANumberIsPoor) {
    const Scene scene = sampleScene();
    Results results = sampleResults();
    results.stages[0].health.balanceError = std::nan("");
    const std::vector<StageWarning> warnings = stageWarnings(MemoryRun(scene, results));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].text.find("is not a finite number"), std::string::npos) << warnings[0].text;
}

}  // namespace
}  // namespace keyblock::test
