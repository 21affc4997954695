// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strength reduction of a scene, and the check whether a factor of safety can be
// computed for a scene at all.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// The scene with the strengths selected by `safety.reduce` divided by `factor` from the start of the run.
/// Joint materials: the tangents of the peak and residual friction angles, the cohesion and the tensile strength, also
/// where later stages change them.
/// Anchors: the strength, the residual strength, the tangent of the friction angle, the softening slip, and the slips
/// and forces of the curve.
/// A factor of 1 leaves every value exactly as it is. A stage that finds no equilibrium ends the run. See theory,
/// "Factor of safety".
/// \pre factor > 0.
Scene withReducedStrength(const Scene& scene, double factor);

/// Reasons why the factor of safety of a checked scene cannot be computed: no stages, a dynamic stage, no strength to
/// reduce, or reduction of bonds with frozen bolt forces. The problems have pointers but no file and line.
std::vector<Problem> checkSafety(const Scene& scene);

}  // namespace keyblock
