// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Preview of a scene before a run: everything at its initial position, openings
// excavated, every bolt with the nodes and anchored points that it would have in a
// run. Nothing is solved.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// A frame that shows the scene before a run. It belongs to no stage or time, and has no contacts and no rock in
/// tunnels.
/// \param scene the scene as solved: the result of `cutScene`.
/// \pre `checkScene` found no error in the scene, and the scene has blocks.
Frame previewFrame(const Scene& scene);

}  // namespace keyblock
