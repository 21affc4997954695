// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extremes: no run is wrong without a sign, ordinary conditions give the right answer,
// and random combinations depend on their seed alone.
#include "solver/verify/extremes/extreme_axes.h"
#include "solver/verify/extremes/extreme_outcome.h"
#include "solver/verify/extremes/extremes.h"
#include "solver/verify/extremes/known_scenes.h"
#include "solver/verify/extremes/limits_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace keyblock {
namespace {

const ExtremeCase& extremeNamed(const std::string& name) {
    return *std::find_if(extremeCases().begin(), extremeCases().end(),
                         [&](const ExtremeCase& one) { return one.name == name; });
}

std::string textOf(const ExtremeRun& run) {
    return run.value + ": " + std::string(wordOf(run.ending)) + ", " + run.quantity + " " +
           std::to_string(run.measured) + " for " + std::to_string(run.expected) + " ± " +
           std::to_string(run.tolerance) + "; " + run.reason;
}

TEST(Extremes, ListHasUniqueNamesAndAtLeastSixtyCases) {
    std::set<std::string> names;
    for (const ExtremeCase& one : extremeCases()) {
        names.insert(one.name);
        EXPECT_FALSE(one.property.empty() || one.reason.empty()) << one.name;
    }
    EXPECT_EQ(names.size(), extremeCases().size());
    EXPECT_GE(names.size(), 60u);
}

TEST(Extremes, OrdinaryConditionsAreRight) {
    for (const auto& group : {restingScenes(), movingScenes(), boltedScenes(), dividedScenes()})
        for (const KnownScene& known : group) {
            const ExtremeCase& one = extremeNamed(known.name + "/" + known.axes.back());
            const auto& axis = extremeAxis(known.axes.back());
            for (std::size_t i = 0; i < one.values.size(); ++i) {
                if (one.values[i] != axis.usual(known.usual)) continue;
                const ExtremeRun run = one.run(i);
                EXPECT_TRUE(run.usual);
                EXPECT_EQ(run.ending, ExtremeEnding::Right) << one.name << ", " << textOf(run);
            }
        }
}

TEST(Extremes, RandomCombinationsAreNeverWrongAndFollowTheirSeed) {
    for (int number = 0; number < 60; ++number) {
        const ExtremeRun run = randomExtreme(7, number);
        EXPECT_NE(run.ending, ExtremeEnding::Wrong) << number << ": " << textOf(run);
    }
    EXPECT_EQ(randomExtreme(7, 3).value, randomExtreme(7, 3).value);
    EXPECT_NE(randomExtreme(7, 3).value, randomExtreme(8, 3).value);
}

TEST(Extremes, InvalidValuesAreRefused) {
    const ExtremeCase& one = extremeNamed("invalid/invalid");
    for (std::size_t i = 1; i < one.values.size(); ++i) {
        const ExtremeRun run = one.run(i);
        EXPECT_EQ(run.ending, ExtremeEnding::Refused) << textOf(run);
        EXPECT_FALSE(run.reason.empty());
    }
}

/// A judge that accepted everything would make every run right.
TEST(Extremes, JudgesFindWrongAnswers) {
    for (const auto& group : {restingScenes(), movingScenes(), boltedScenes()})
        for (const KnownScene& known : group) {
            const ExtremeOutcome outcome = runExtreme(placed(known.usual, known.scene(known.usual)));
            ASSERT_TRUE(outcome.solved) << known.name;
            Solved changed = *outcome.solved;
            Frame& last = changed.results.frames.back();
            for (BlockState& block : last.blocks) {
                block.displacement += Point(0.2, 0.3);
                block.velocity += Point(2.0, 3.0);
                block.rotation += 0.1;
            }
            for (ContactFrame& contact : last.contacts) contact.normalForce *= 1.1;
            for (BoltFrame& bolt : last.bolts)
                for (BoltNodeFrame& node : bolt.nodes) node.axialForce = 1.1 * node.axialForce + 1e6;
            for (StageResult& stage : changed.results.stages) stage.outcome = Outcome::Equilibrium;
            Findings findings;
            known.judge(known.usual, changed, findings);
            EXPECT_FALSE(findings.allRight()) << known.name;
        }
}

TEST(Findings, ANumberThatIsNotFiniteIsNeverRight) {
    Findings findings;
    findings.near("x", std::nan(""), 1.0, 1e9);
    EXPECT_FALSE(findings.allRight());
    Findings limit;
    limit.atMost("x", 2.0, 1.0, 0.5);
    EXPECT_FALSE(limit.allRight());
    Findings below;
    below.atMost("x", -5.0, 1.0, 0.0);
    EXPECT_TRUE(below.allRight());
}

TEST(LimitsPage, NamesTheLastRightAndTheFirstOtherValue) {
    ExtremeCaseRuns one;
    one.one = extremeNamed("box/penalty");
    one.one.values = {1.0, 10.0, 100.0};
    for (const auto& [value, ending] : {std::pair("1", ExtremeEnding::Warned), std::pair("10", ExtremeEnding::Right),
                                        std::pair("100", ExtremeEnding::Stopped)}) {
        ExtremeRun run;
        run.value = value;
        run.ending = ending;
        run.usual = value == std::string("10");
        run.reason = ending == ExtremeEnding::Right ? "" : "because";
        one.runs.push_back(run);
    }
    const std::string page = limitsPage({one}, {});
    EXPECT_NE(page.find("| box | 10 | 1 warned | 10 | 100 stopped |"), std::string::npos) << page;
    EXPECT_NE(page.find("- box, 1, warned: `because`"), std::string::npos) << page;
}

}  // namespace
}  // namespace keyblock
