// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the document to masses, stiffnesses, slots and meshes.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// \pre the scene was checked without errors.
Model makeModel(const Scene& scene);

}  // namespace keyblock
