// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolts of the published tables and of the samples as bar problems. The
// joint lies at x = 1 m between two blocks of 1 m; nodes are given by their x.
#pragma once

#include "tests/verify/reference/bar.h"

namespace keyblock::reference {

inline constexpr double barArea = 3.14159265358979323846 * 0.01 * 0.01;  // [m²] of 20 mm

/// 60 GPa, 1 m³: the rock of the samples.
inline constexpr double rockStiffness = 60e9;

/// Nodes from x = `from` to `to` in equal divisions.
std::vector<double> evenNodes(double from, double to, int divisions);

/// One spring of the given curve at every node that lies in a block; a node on the joint gets none.
void anchorEveryNode(BarProblem& problem, const Curve& curve, std::optional<double> peak, double residual);

/// Plate at the last node.
void addPlate(BarProblem& problem, double stiffness, std::optional<double> strength);

void makeRockElastic(BarProblem& problem, double youngsModulus);

enum class Mesh { JointInElement, JointAtNode };

/// The paper's rebar: 60 springs of 84.78 kN/mm, peak as given, residual 2.24 kN.
BarProblem paperRebar(double youngsModulus, double peak, Mesh mesh);

/// The same without strength, on 61 nodes, with a plate of 1e9 N/m.
BarProblem elasticRebar(double springStiffness, double plateStiffness);

/// The paper's D-bolt, held at nodes 3, 13, 37 and 54 of 61.
BarProblem paperDBolt(const Curve& steel, bool plate);

/// 200 kN on springs that stand for 254.34 MN/m² along 1 m each side, E 200 GPa, the joint in the middle of an element;
/// `perSide` springs each side. \param plateStiffness 0: none.
BarProblem shearLag(int perSide, double plateStiffness);

/// The same bond shared by length among the nodes of a bolt from end to end, ends and joint clipped.
BarProblem shearLagByLength(int divisions, double plateStiffness);

/// A bolt from x = 0 to `length` across a joint at `joint`, in rock of 60 GPa, the blocks as long as the bolt.
BarProblem boltAcross(double joint, double length, int divisions, double area, const Curve& steel);

/// Holds the stretch [from, to] by a curve per metre, shared among the nodes by their tributary lengths clipped at the
/// stretch and at the joint.
void anchorByLength(BarProblem& problem, double joint, double from, double to, const BarSpring& perMetre);

extern const Curve textSteel, tableSteel;  // strain, stress [Pa]

}  // namespace keyblock::reference
