// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divisions are used as given; where they are too coarse at a joint, the user is
// warned.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// A warning for every anchor named by its place whose node lies on a joint or in a gap, where it holds nothing; for
/// every bolt whose elements at a joint are longer than 0.3 of the transfer length of its bond, with the error of a pull;
/// and, unless the scene is a pull test, for given elements at a joint that are longer than an eighth of the length over
/// which a dowel bends, or a node on a joint (theory, "Divisions").
/// \pre the scene has no error.
std::vector<Problem> checkMeshes(const Scene& scene);

}  // namespace keyblock
