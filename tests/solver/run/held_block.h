// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block that gravity pulls off a fixed one, and a bolt across the joint that
// holds it.
#pragma once

#include "solver/results/bolt_use.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

namespace keyblock::test {

inline constexpr double heldWeight = 2700.0 * gravity;  // of the right block [N]

/// Steel that bears up to `strength` [N].
inline BoltType barOfStrength(double strength) {
    const double stress = strength / barArea();
    return steelType(barArea(), {{0.0, 0.0}, {stress / 200e9, stress}, {0.01, stress}});
}

/// Gravity pulls the right block off the fixed left one; a bolt across the joint holds it.
inline Scene heldBlock(BoltType type, const Anchor& anchor) {
    Scene scene = twoBlocks(10e9, 1.0, 2.0);
    scene.analysis.gravity = {gravity, 0.0};
    type.anchors = {anchor};
    addBolt(scene, type, 0.5, 1.5, 10, PlateKind::None);
    scene.stages = {settle()};
    return scene;
}

inline Anchor elastic() { return anchorRange(Per::Node, AnchorLaw::Elastic, 100e6, std::nullopt, 0.0); }

inline double share(const BoltUse& use, BoltStrength strength) {
    return use.use[static_cast<std::size_t>(strength)].value();
}

}  // namespace keyblock::test
