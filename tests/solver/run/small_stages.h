// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What several tests of whole runs share: stages, a box on a base, and what is read from results.
#pragma once

#include "solver/run/run.h"
#include "solver/run/safety.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock::test {

inline constexpr double weight = 2700.0 * gravity;  // [N] of a cube of 1 m

inline Stage settle() {
    Stage stage;
    stage.name = "settle";
    return stage;
}

/// A dynamic stage called `motion`.
inline Stage dynamic(double duration, double timeStep) {
    Stage stage;
    stage.name = "motion";
    stage.kind = StageKind::Dynamic;
    stage.duration = duration;
    stage.timeStep = timeStep;
    return stage;
}

/// A box on a fixed base, gravity turned by `angle`°.
inline Scene boxOnBase(double angle, double frictionAngle) {
    Scene scene = emptyScene(10e9, 0.2, frictionAngle);
    scene.blocks = {boxBlock("base", {-1, -1}, {9, 0}), boxBlock("box", {0, 0}, {1, 1})};
    Support support;
    support.blockAt = Point(4.0, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {gravity * std::sin(angle * degree), -gravity * std::cos(angle * degree)};
    scene.output.frames = 10;
    return scene;
}

inline SceneJoint line(const std::string& name, const Point& from, const Point& to) {
    SceneJoint joint;
    joint.name = name;
    joint.points = {from, to};
    return joint;
}

/// The second block in the last frame: the box on the base.
inline const BlockState& box(const Results& results) { return results.frames.back().blocks[1]; }

inline const Frame& last(const Solved& solved) { return solved.results.frames.back(); }

/// The last frame of a stage; the first frame of the run if the stage has none.
inline const Frame& lastOf(const Results& results, int stage) {
    const auto found = std::find_if(results.frames.rbegin(), results.frames.rend(),
                                    [&](const Frame& frame) { return frame.stage == stage; });
    return found == results.frames.rend() ? results.frames.front() : *found;
}

inline const Frame& lastOf(const Solved& solved, int stage) { return lastOf(solved.results, stage); }

/// Expects that every stage ended in equilibrium or after its duration, with an energy balance error below `balance`.
inline void expectDone(const Results& results, double balance = 1e-3) {
    for (const StageResult& stage : results.stages) {
        EXPECT_TRUE(stage.outcome == Outcome::Equilibrium || stage.outcome == Outcome::Duration) << stage.message;
        EXPECT_LT(std::abs(stage.health.balanceError), balance);
    }
}

inline SafetyFactor safetyOf(const Scene& scene) {
    Control control;
    const auto trial = [&](const Scene& reduced, double, Sink& sink) { run(reduced, sink, control); };
    return findSafetyFactor(scene, trial);
}

}  // namespace keyblock::test
