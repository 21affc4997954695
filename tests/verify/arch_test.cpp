// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An arch of nine voussoirs on a tilted base against limit analysis: below the
// critical tilt it stands, above it becomes a mechanism of four hinges, and neither
// verdict takes long.
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"
#include "tests/verify/reference/hinged_arch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace keyblock {
namespace {

constexpr reference::Arch arch{9, 1.0, 0.2};

Point on(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

Scene tiltedArch(double tilt) {
    Scene scene = emptyScene(10e9, 0.2, 60.0);
    const double inner = arch.mean - 0.5 * arch.thickness, outer = arch.mean + 0.5 * arch.thickness;
    for (int v = 0; v < arch.voussoirs; ++v) {
        const double from = std::numbers::pi * v / arch.voussoirs, to = std::numbers::pi * (v + 1) / arch.voussoirs;
        scene.blocks.push_back(boxBlock("v" + std::to_string(v), {}, {}));
        scene.blocks.back().points = {on(inner, from), on(outer, from), on(outer, to), on(inner, to)};
    }
    for (const double side : {-1.0, 1.0}) {
        const double middle = side * arch.mean;
        scene.blocks.push_back(boxBlock(side < 0.0 ? "left" : "right", {middle - 0.3, -0.3}, {middle + 0.3, 0.0}));
        scene.supports.emplace_back().blockAt = Point(middle, -0.15);
    }
    scene.analysis.gravity = {gravity * std::sin(tilt), -gravity * std::cos(tilt)};
    scene.stages = {test::settle()};
    return scene;
}

TEST(Arch, FourHingesOfTheReferenceAlternate) {
    const reference::ArchCollapse collapse = reference::collapseOf(arch);
    EXPECT_NEAR(collapse.tilt / degree, 16.676, 1e-3);  // a program of its own gave tan = 0.2995540
    EXPECT_EQ(collapse.joints, (std::array<int, 4>{0, 2, 5, 8}));
    EXPECT_EQ(collapse.atIntrados, (std::array<bool, 4>{false, true, false, true}));
}

TEST(Arch, StandsJustBelowTheCriticalTilt) {
    const Results results = runInMemory(tiltedArch(reference::collapseOf(arch).tilt - 0.1 * degree));
    EXPECT_EQ(results.stages[0].outcome, Outcome::Equilibrium) << results.stages[0].message;
}

TEST(Arch, CollapsesAboveTheCriticalTilt) {
    for (const double above : {0.1, 3.0, 7.0}) {
        const Results results = runInMemory(tiltedArch(reference::collapseOf(arch).tilt + above * degree));
        EXPECT_EQ(results.stages[0].outcome, Outcome::Collapse) << above << "°: " << results.stages[0].message;
        EXPECT_LT(results.stages[0].health.steps, 5000) << above;
    }
}

}  // namespace
}  // namespace keyblock
