// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that the program uses if the scene gives null. The engine and the field table
// both take them from here, so that forms show the values that a run uses.
#pragma once

#include "solver/scene/scene.h"

#include <string>

namespace keyblock {

inline constexpr double automaticBody = 1e-3;  // for `until.body`, relative to the block's weight
inline constexpr double automaticSmallest = 0.01;  // for `until.smallest` [m²]
inline constexpr int automaticIterations = 20000;  // for `limits.iterations`

/// Automatic value of `until.unbalanced`, relative to the reference force: 1e-4, or `analysis.tolerance` if that is
/// smaller.
double automaticUnbalanced(const Scene& scene);

/// Automatic value of the longest time step [s] of a dynamic stage.
double automaticTimeStep(const Scene& scene, const Stage& stage);

/// Second moment of area [m⁴]: π/64·d⁴ for a solid bar of diameter d; π/64·(d⁴ − d_i⁴) for a tube of area A with the
/// outer diameter d and the inner diameter d_i, where d_i² = d² − 4A/π.
double automaticSecondMoment(const BoltType& type);

/// Plastic section modulus [m³]: d³/6 for a solid bar, (d³ − d_i³)/6 for a tube, with d and d_i as in
/// `automaticSecondMoment`.
double automaticPlasticModulus(const BoltType& type);

/// Young's modulus [Pa]: slope of the first segment of `steel`, or 200 GPa if there is no `steel`.
double automaticYoungsModulus(const BoltType& type);

/// Name of the default joint material of blocks and of the domain: the first joint material of the scene. Empty if the
/// scene has none; the built-in joint material then applies.
std::string automaticJointMaterial(const Scene& scene);

/// Name of the default joint material of joints, joint sets and Voronoi cells: the joint material of the domain or, if
/// the domain has none, `automaticJointMaterial`.
std::string automaticTraceMaterial(const Scene& scene);

}  // namespace keyblock
