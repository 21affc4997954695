// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that the program takes where a scene gives null. The engine and the field
// table both take them from here, so that a form shows what a run uses.
#pragma once

#include "solver/scene/scene.h"

#include <string>

namespace keyblock {

inline constexpr double automaticBody = 1e-3;  // `until.body`, of a block's weight
inline constexpr double automaticSmallest = 0.01;  // `until.smallest` [m²]
inline constexpr int automaticIterations = 20000;  // `limits.iterations`

/// `until.unbalanced`, over the reference force: 1e-4, or the tolerance of the analysis if that is less.
double automaticUnbalanced(const Scene& scene);

/// The longest time step of a dynamic stage [s].
double automaticTimeStep(const Stage& stage);

/// Of a tube by its diameter and area, π/64·(d⁴ − d_i⁴), d_i² = d² − 4A/π; of a full bar π·d⁴/64 [m⁴].
double automaticSecondMoment(const BoltType& type);

/// Of a tube (d³ − d_i³)/6; of a full bar d³/6 [m³].
double automaticPlasticModulus(const BoltType& type);

/// Young's modulus of the first piece of `steel`; without `steel` 200 GPa [Pa].
double automaticYoungsModulus(const BoltType& type);

/// Joint material of the faces of blocks and of the domain: the first of the scene; empty: the built-in one.
std::string automaticJointMaterial(const Scene& scene);

/// Joint material of joints, joint sets and cells: that of the domain, else the first of the scene.
std::string automaticTraceMaterial(const Scene& scene);

}  // namespace keyblock
