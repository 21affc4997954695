// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates the model from the document: masses, stiffnesses, borehole slots and bolt
// meshes.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// Creates the model of a scene.
/// \pre the scene has been checked and has no errors.
Model makeModel(const Scene& scene);

}  // namespace keyblock
