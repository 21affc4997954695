// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts that the scenes with a known answer have in common.
#pragma once

#include "solver/verify/extremes/known_scenes.h"
#include "solver/verify/scenes.h"

namespace keyblock {

/// A scene with the rock, the joint and the numerical settings of the conditions, but without blocks. The material
/// `rock` is that of the block, `base` that of its support.
Scene conditionedScene(const Conditions& conditions);

/// A fixed block of the material `base`.
void addBase(Scene& scene, const Point& low, const Point& high);

/// A dynamic stage of `steps` time steps.
Stage conditionedMotion(const Conditions& conditions);

Stage conditionedRest();

/// Weight of the block of the size of the conditions, `width` and `height` in units of the size [N].
double weightOf(const Conditions& conditions, double width = 1.0, double height = 1.0);

/// Stiffness of a contact spring [N/m].
double contactStiffness(const Conditions& conditions);

/// Deflection of a block of that size on two corners: of the contacts, and of its own rock [m].
double restingDeflection(const Conditions& conditions);

/// Duration of the last stage [s]; it may be shorter than planned.
double lastTime(const Solved& solved);

const BlockState& lastBlock(const Solved& solved, std::size_t index);

/// Displacement of a block at the end, in the axes of the scene [m].
Point moved(const Conditions& conditions, const Solved& solved, std::size_t index);

/// Sums of the normal forces and of the magnitudes of the shear forces between two blocks at the end [N].
struct ContactSums {
    double normal = 0.0, shear = 0.0;
};
ContactSums contactsBetween(const Solved& solved, int a, int b);

/// True if every stage ended in equilibrium or after its duration.
bool endedWell(const Solved& solved);

/// True if the last stage found an unstable block.
bool endedUnstable(const Solved& solved);

/// Sum of the contact forces on a block at the end, in the axes of the scene [N].
Point contactForceOn(const Conditions& conditions, const Solved& solved, int block);

/// Deflection of contacts of a block under half of a force each [m]; none where multipliers keep them closed.
double contactClosure(const Conditions& conditions, double force);

/// Share by which forces may deviate: 0.1 %, or ten times the iteration tolerance up to 2 %.
double forceShare(const Conditions& conditions);

/// Largest magnitude of the axial force in the first bolt at the end [N].
double axialForce(const Solved& solved);

}  // namespace keyblock
