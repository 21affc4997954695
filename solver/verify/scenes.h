// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scenes of the verification, built in code so that no file and no library
// of bolts lies between a law and the number that it is checked against. All of them
// run at a pass tolerance of 1e-10.
#pragma once

#include "solver/scene/scene.h"

#include <string>

namespace keyblock {

inline constexpr double gravity = 9.81;  // [m/s²]
inline constexpr double rigidRock = 6e13;  // [Pa] Young's modulus that counts as rigid compared with a bolt

/// Plane stress, 1 m thick, one rock, one joint of friction angle `frictionAngle` [°]; no block yet.
Scene emptyScene(double youngsModulus, double poissonsRatio, double frictionAngle);

/// Rectangle between two corners [m].
Block boxBlock(const std::string& name, const Point& low, const Point& high);

/// A block of 1 m × 0.5 m, the monitor `slider`, on a fixed slope of `slope` [°] falling towards +x, released at t = 0
/// in a dynamic stage of 1 ms steps.
Scene inclineScene(double slope, double frictionAngle, double duration);

/// Two blocks that touch at x = `joint` [m], `length` [m] from end to end and 1 m high. The left one is fixed; the
/// joint is smooth. One monitor, `opening`.
Scene twoBlocks(double youngsModulus, double joint, double length);

/// Pulls the right block along x, rotation held, in equal increments.
Stage pullStage(const Scene& scene, double displacement, int increments);

/// Loads the right block along x in equal increments [N].
Stage loadStage(const Scene& scene, double force, int increments);

/// Bolt along y = 0.5 m, and the monitor `joint force` in the element that crosses or touches the joint from the
/// left; the scene's opening stays its first monitor.
void addBolt(Scene& scene, const BoltType& type, double from, double to, int divisions, PlateKind plate);

/// Type of the given steel area [m²] whose shank is linear and unbreakable.
BoltType linearType(double area, double youngsModulus);

/// The same with a backbone (strain, stress [Pa]) from the origin.
BoltType steelType(double area, const Table& steel);

/// Anchors of one law along a stretch of the bolt, or at its every node.
Anchor anchorRange(Per per, AnchorLaw law, double stiffness, std::optional<double> strength, double residual);

/// Anchor at the node nearest to `s` [m] from the far end.
Anchor anchorAt(double s, AnchorLaw law, double stiffness);

/// Area of a round bar of 20 mm [m²].
double barArea();

/// The paper's rebar with a given modulus [Pa] and peak [N], on `divisions` 59 (joint in an element) or 60 (joint at a
/// node), rock of `rockModulus`; pulled by `displacement` in `increments`.
Scene paperRebar(double youngsModulus, double peak, int divisions, double rockModulus, double displacement,
                 int increments);

/// The paper's D-bolt, with a plate of 1e9 N/m or none.
Scene paperDBolt(const Table& steel, PlateKind plate, double rockModulus, double displacement, int increments);

/// The paper's rebar without debonding under 200 kN, plate 1e9 N/m.
Scene elasticRebar(double springStiffness, double rockModulus);

}  // namespace keyblock
