// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks of bolt meshes. Divisions are used as given, but the user is warned if they are
// too coarse at a joint.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// Warnings about bolt meshes (theory, "Divisions"). A warning is issued for
/// - an anchor at a given position whose node lies on a joint, in a gap or outside the rock, where it carries no force;
/// - elements at a joint that are longer than 0.3 times the transfer length of the bond; the warning states the errors
///   that this causes in a pull test;
/// - a bond given per node on a bolt with automatic divisions, because its strength depends on the number of nodes;
/// - user-defined divisions of a bolt that may be sheared, if a node lies on a joint or if elements at a joint are
///   longer than an eighth of the bending length of a dowel.
/// \pre the scene has no errors.
std::vector<Problem> checkMeshes(const Scene& scene);

}  // namespace keyblock
