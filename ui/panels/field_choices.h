// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields that hold names of other objects: which names there are to choose from.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Names that the field may hold in this scene, as the person meets them in the tree; none where it holds no name.
std::optional<std::vector<std::string>> choicesOf(const Scene& scene, const Structure& structure, const Field& field);

}  // namespace keyblock
