// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Given divisions are used as given; where they are too coarse for a joint to
// shear the bolt, a person should know before believing the dowel forces.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// A warning for every anchor named by its place whose node lies on a joint or in a gap, where it holds nothing; and for
/// every bolt whose given elements at a joint are longer than an eighth of the length over which a dowel bends, or that
/// has a node on a joint (theory, "Divisions"). Automatic divisions never are or do.
/// \pre the scene has no error.
std::vector<Problem> checkMeshes(const Scene& scene);

}  // namespace keyblock
