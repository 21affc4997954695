// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields that name other objects: the names to choose from.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Names that the field may hold in this scene, in the order of the tree; none if the field holds no name.
std::optional<std::vector<std::string>> choicesOf(const Scene& scene, const Field& field);

}  // namespace keyblock
