// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes of joint strength by a stage: weathering, water, grouting. Forces do not
// change at that moment. Joints that are now too weak for their forces fail afterwards
// through the same limits as all other parts.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Contents of Model::joints with the strengths set by the stages up to and including `stage` (−1: as given in the
/// scene). The built-in material and intact rock are included.
std::vector<JointModel> jointModels(const Scene& scene, int stage);

/// Sets the model's joint strengths to those of `stage` and determines the governing material of every contact again.
/// Forces are kept, and the total energy does not change (theory, "Changed joints").
/// \pre the model has the strengths of the previous stage.
void changeJoints(const Scene& scene, int stage, Model& model, State& state);

}  // namespace keyblock
