// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene as drawn: everything where it was put, openings open, every
// bolt with the nodes and anchored points that a run would give it. Nothing is
// solved.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// A frame of no stage and time; rock in tunnels is left out, no contact is looked for.
/// \param scene as it is solved: what `cutScene` makes of it.
/// \pre the scene was checked without errors and has blocks.
Frame previewFrame(const Scene& scene);

}  // namespace keyblock
