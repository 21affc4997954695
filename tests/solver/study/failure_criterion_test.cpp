// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/failure_criterion.h"

#include <gtest/gtest.h>

#include <map>

namespace keyblock {
namespace {

Scene sceneWithMonitor() {
    Scene scene;
    Monitor key;
    key.name = "key";
    key.point = Point(0.0, 0.0);
    scene.monitors.push_back(key);
    return scene;
}

std::optional<bool> decided(const std::string& text, const std::map<std::string, double>& values, bool lost = false) {
    const FailureReading reading = readFailure(text, sceneWithMonitor());
    EXPECT_TRUE(reading.criterion) << text << ": " << reading.problem;
    if (!reading.criterion) return std::nullopt;
    return fails(
        *reading.criterion,
        [&](const std::string& quantity) -> std::optional<double> {
            const auto found = values.find(quantity);
            return found == values.end() ? std::nullopt : std::optional(found->second);
        },
        lost);
}

TEST(FailureCriterion, ComparesQuantitiesWithNumbers) {
    EXPECT_EQ(decided("max key.u > 0.05", {{"max key.u", 0.06}}), true);
    EXPECT_EQ(decided("max key.u > 0.05", {{"max key.u", 0.05}}), false);
    EXPECT_EQ(decided("max key.u >= 0.05", {{"max key.u", 0.05}}), true);
    EXPECT_EQ(decided("min key.uy <-1e-3", {{"min key.uy", -0.002}}), true);
    EXPECT_EQ(decided("not max key.u <= 0.05", {{"max key.u", 0.06}}), true);
    EXPECT_EQ(decided("not stands", {{"stands", 0.0}}), true);
    EXPECT_EQ(decided("stands", {{"stands", 0.0}}), false);
    EXPECT_EQ(decided("any lost bolt", {}, true), true);
    EXPECT_EQ(decided("not lost bolt", {}, true), false);
}

TEST(FailureCriterion, AndBindsCloserThanOr) {
    const std::string text = "lost bolt or max key.u > 1 and stands";
    EXPECT_EQ(decided(text, {{"max key.u", 2.0}, {"stands", 1.0}}), true);
    EXPECT_EQ(decided(text, {{"max key.u", 2.0}, {"stands", 0.0}}), false);
    EXPECT_EQ(decided(text, {{"max key.u", 0.0}, {"stands", 0.0}}, true), true);
}

TEST(FailureCriterion, AMissingValueLeavesOpenOnlyWhatDependsOnIt) {
    EXPECT_EQ(decided("max key.u > 1", {}), std::nullopt);
    EXPECT_EQ(decided("max key.u > 1 or stands", {{"stands", 1.0}}), true);
    EXPECT_EQ(decided("max key.u > 1 and stands", {{"stands", 0.0}}), false);
    EXPECT_EQ(decided("max key.u > 1 or stands", {{"stands", 0.0}}), std::nullopt);
}

TEST(FailureCriterion, WrongTextsAreExplained) {
    for (const auto& [text, part] : std::map<std::string, std::string>{{"max kye.u > 1", "kye"},
                                                                       {"max key.u > much", "'much' is not a number"},
                                                                       {"max key.u", "is not a condition"},
                                                                       {"order debonding > 1", "order"},
                                                                       {"stands or ", "is not a condition"}}) {
        const FailureReading reading = readFailure(text, sceneWithMonitor());
        EXPECT_FALSE(reading.criterion) << text;
        EXPECT_NE(reading.problem.find(part), std::string::npos) << reading.problem;
        EXPECT_FALSE(reading.remedy.empty());
    }
}

}  // namespace
}  // namespace keyblock
