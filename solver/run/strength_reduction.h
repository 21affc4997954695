// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene with its strengths divided by a factor, and whether a scene can be
// searched for its factor of safety at all.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// The scene with what `safety.reduce` names divided by `factor` from the start on: tan of friction angles (the
/// residual one too), cohesion and tensile strength of joint materials, changes in later stages among them; strength,
/// residual, tan of the friction angle and curves of anchors. A factor of 1 changes no digit. A stage that finds no
/// equilibrium ends the run. Theory, "Factor of safety".
/// \pre factor > 0.
Scene withReducedStrength(const Scene& scene, double factor);

/// What keeps a checked scene from having a factor of safety: no stage, a dynamic one, nothing that could be reduced,
/// bonds that are reduced while bolt forces are frozen.
/// With pointers, without file and line.
std::vector<Problem> checkSafety(const Scene& scene);

}  // namespace keyblock
