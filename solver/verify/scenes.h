// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verification scenes, built in code so that neither a file nor the bolt library
// comes between a law and the number against which it is checked. All of them use an
// iteration tolerance of 1e-10.
#pragma once

#include "solver/scene/scene.h"

#include <numbers>
#include <string>

namespace keyblock {

inline constexpr double degree = std::numbers::pi / 180.0;  // [rad]
inline constexpr double gravity = 9.81;  // [m/s²]
inline constexpr double hardRock = 60e9;  // [Pa] Young's modulus
inline constexpr double rigidRock = 6e13;  // [Pa] Young's modulus of rock that is practically rigid relative to a bolt

/// A scene without blocks: plane stress, 1 m thick, one rock material and one joint material.
/// \param youngsModulus Young's modulus of the rock [Pa].
/// \param frictionAngle friction angle of the joint material [°].
Scene emptyScene(double youngsModulus, double poissonsRatio, double frictionAngle);

/// Rectangular block with the given lower left and upper right corners [m].
Block boxBlock(const std::string& name, const Point& low, const Point& high);

/// A block of 1 m × 0.5 m on a fixed slope that dips at `slope` [°] towards +x. The block is released at t = 0 in a
/// dynamic stage with time steps of 1 ms. The monitor `slider` records its displacement.
/// \param frictionAngle friction angle of the joint material [°].
/// \param duration duration of the stage [s].
Scene inclineScene(double slope, double frictionAngle, double duration);

/// Two blocks that touch at x = `joint` [m], together `length` [m] long and 1 m high. The left block is fixed; the
/// joint is frictionless. The monitor `opening` records the opening of the joint.
/// \param youngsModulus Young's modulus of the rock [Pa].
Scene twoBlocks(double youngsModulus, double joint, double length);

/// A stage that moves the right block of `twoBlocks` along x without rotation, in equal increments.
/// \param displacement displacement at the end of the stage [m].
Stage pullStage(const Scene& scene, double displacement, int increments);

/// A stage that loads the right block of `twoBlocks` along x in equal increments.
/// \param force force at the end of the stage [N].
Stage loadStage(const Scene& scene, double force, int increments);

/// Adds a bolt along y = 0.5 m, and a monitor named `joint force`. The monitor records the axial force in the element
/// that crosses the joint or, if the joint is at a node, in the element to the left of the joint.
/// \param from, to x coordinates of the far end and of the head [m].
void addBolt(Scene& scene, const BoltType& type, double from, double to, int divisions, PlateKind plate);

/// Bolt type with a linear elastic shank of unlimited strength.
/// \param area steel area [m²]. \param youngsModulus Young's modulus of the steel [Pa].
BoltType linearType(double area, double youngsModulus);

/// Bolt type like `linearType`, but with a stress–strain curve of the steel. \param area steel area [m²].
/// \param steel points (strain, stress [Pa]) of the curve, starting at the origin.
BoltType steelType(double area, const Table& steel);

/// Anchors with the same bond law along the whole bolt.
/// \param per whether stiffness, strength and residual strength are given per node or per unit length.
Anchor anchorRange(Per per, AnchorLaw law, double stiffness, std::optional<double> strength, double residual);

/// An anchor at the node whose distance from the far end is closest to `s` [m]. \param stiffness bond stiffness [N/m].
Anchor anchorAt(double s, AnchorLaw law, double stiffness);

/// Cross-sectional area of a round bar of 20 mm diameter [m²].
double barArea();

/// The rebar example of the bolt model paper, across the joint between two blocks. The right block is pulled by
/// `displacement` [m] in equal increments.
/// \param youngsModulus Young's modulus of the bar [Pa]. \param peak peak bond force per node [N].
/// \param divisions 59: the joint is within an element; 60: it is at a node.
/// \param rockModulus Young's modulus of the rock [Pa].
Scene paperRebar(double youngsModulus, double peak, int divisions, double rockModulus, double displacement,
                 int increments);

/// The D-bolt of the same paper. The right block is pulled as in `paperRebar`.
/// \param steel stress–strain curve, as in `steelType`.
/// \param plate whether there is a face plate, with a stiffness of 1e9 N/m.
Scene paperDBolt(const Table& steel, PlateKind plate, double rockModulus, double displacement, int increments);

/// The rebar of the same paper with an elastic bond and a face plate of stiffness 1e9 N/m, under a load of 200 kN.
/// \param springStiffness bond stiffness per node [N/m].
Scene elasticRebar(double springStiffness, double rockModulus);

}  // namespace keyblock
