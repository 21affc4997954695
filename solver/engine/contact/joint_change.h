// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints whose strength a stage changes: weathering, water, grout. The forces of
// that moment stay; what is too weak for them fails afterwards, through the same
// limits as everything else.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Strengths of the scene's joint materials as its stages up to and with `stage` set them (−1: as they are given), with
/// the rows that no scene lists.
std::vector<JointModel> jointModels(const Scene& scene, int stage);

/// Gives the model the strengths of `stage` and gives every contact the one that governs it now; no force and no
/// energy changes (theory, "Changed joints"). \pre the model has the strengths of the stage before.
void changeJoints(const Scene& scene, int stage, Model& model, State& state);

}  // namespace keyblock
