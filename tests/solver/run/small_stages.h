// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stages and the box on a base that several tests of whole runs begin with.
#pragma once

#include "solver/verify/scenes.h"

#include <cmath>
#include <numbers>

namespace keyblock::test {

inline constexpr double degree = std::numbers::pi / 180.0;

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

}  // namespace keyblock::test
