// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/run_forecast.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

/// A static stage in which a load changes.
PlannedStage loadedStage(double passes) {
    PlannedStage stage;
    stage.steps = 5.0;
    stage.passes = passes;
    return stage;
}

PilotStage pilotStage(int stage, double seconds, long passes, bool over) {
    PilotStage part;
    part.stage = stage;
    part.seconds = seconds;
    part.passes = passes;
    part.time = over ? 1.0 : 0.0;
    part.over = over;
    return part;
}

PilotRun pilotOf(std::vector<PilotStage> stages) {
    PilotRun pilot;
    for (const PilotStage& stage : stages) pilot.seconds += stage.seconds;
    pilot.stages = std::move(stages);
    return pilot;
}

/// Without an earlier stage, the planned number of iterations is all there is: 0.1 s made 5 of the 200.
TEST(RunForecast, AFirstSearchInProgressTakesThePlannedIterations) {
    const RunForecast forecast = forecastFrom(pilotOf({pilotStage(0, 0.1, 5, false)}), {loadedStage(200.0)});
    EXPECT_TRUE(forecast.searching);
    EXPECT_NEAR(forecast.seconds, 200.0 * 0.02, 1e-12);
    EXPECT_NEAR(forecast.stages[0].passes, 200.0, 1e-9);
}

/// If every joint bond broke, the second stage would take 15,000 iterations; the first one took 14.
TEST(RunForecast, ASearchInProgressTakesAsLongAsTheLoadedStagesBefore) {
    const std::vector<PlannedStage> planned(3, loadedStage(15000.0));
    const RunForecast forecast = forecastFrom(pilotOf({pilotStage(0, 0.28, 14, true), pilotStage(1, 0.1, 5, false)}),
                                              planned);
    EXPECT_FALSE(forecast.searching);
    EXPECT_NEAR(forecast.stages[1].seconds, 0.28, 1e-12);
    EXPECT_NEAR(forecast.stages[2].seconds, 0.28, 1e-12);
    EXPECT_NEAR(forecast.seconds, 3 * 0.28, 1e-12);
}

/// A search that has already taken longer than the stage before is expected to take as long again.
TEST(RunForecast, ALongSearchInProgressTakesAsLongAgain) {
    const std::vector<PlannedStage> planned(2, loadedStage(15000.0));
    const RunForecast forecast = forecastFrom(pilotOf({pilotStage(0, 0.1, 14, true), pilotStage(1, 0.4, 60, false)}),
                                              planned);
    EXPECT_NEAR(forecast.stages[1].seconds, 0.8, 1e-12);
}

}  // namespace
}  // namespace keyblock
