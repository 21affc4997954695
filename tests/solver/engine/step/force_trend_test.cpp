// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact forces are continued from step to step: forces that change evenly are
// predicted, and those of new contacts, of other links and after a step without sweeps
// are left as they are.
#include "solver/engine/step/force_trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace keyblock {
namespace {

Link contact(LinkKind kind, std::uint64_t features) {
    Link link;
    link.kind = kind;
    link.a = 0;
    link.b = 1;
    link.features = features;
    return link;
}

StepProblem withLinks(std::vector<Link> links) {
    StepProblem problem;
    problem.links = std::move(links);
    return problem;
}

std::vector<double> predicted(ForceTrend& trend, const StepProblem& problem, std::vector<double> forces) {
    trend.predict(problem, forces);
    trend.endStep();
    return forces;
}

const Link normal = contact(LinkKind::Normal, 1), friction = contact(LinkKind::Friction, 1);
const Link other = contact(LinkKind::Normal, 2), bolt = contact(LinkKind::Axial, 0);

TEST(ForceTrend, ContinuesForcesThatChangeEvenly) {
    ForceTrend trend;
    const StepProblem problem = withLinks({normal, friction, bolt});
    EXPECT_EQ(predicted(trend, problem, {-10.0, 4.0, 7.0}), (std::vector{-10.0, 4.0, 7.0}));
    for (int step = 1; step < 4; ++step) {
        const double before = -10.0 - 2.0 * step, after = before - 2.0;
        const std::vector<double> forces = predicted(trend, problem, {before, 4.0, 7.0 + step});
        EXPECT_LT(forces[0], before);
        EXPECT_GE(forces[0], after);
        EXPECT_LE(std::abs(forces[0] - after), 0.5 * std::abs(before - after));
        EXPECT_EQ(forces[1], 4.0);
        EXPECT_EQ(forces[2], 7.0 + step);  // of a bolt
    }
}

TEST(ForceTrend, FindsContactsAgainAndLeavesNewOnesAsTheyAre) {
    ForceTrend trend;
    predicted(trend, withLinks({normal, friction}), {-10.0, 4.0});
    const std::vector<double> forces = predicted(trend, withLinks({other, normal, friction}), {-3.0, -20.0, 5.0});
    EXPECT_EQ(forces[0], -3.0);
    EXPECT_LT(forces[1], -20.0);
    EXPECT_GT(forces[2], 5.0);
}

TEST(ForceTrend, EndsWithAStepInWhichNothingWasPredicted) {
    ForceTrend trend;
    const StepProblem problem = withLinks({normal});
    predicted(trend, problem, {-10.0});
    trend.endStep();
    EXPECT_EQ(predicted(trend, problem, {-20.0}), (std::vector{-20.0}));
}

}  // namespace
}  // namespace keyblock
