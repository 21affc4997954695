// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Choices for fields that name another object.
#pragma once

#include "solver/scene/field.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Names that the field can refer to in this scene, in the order of the scene tree; null if the field does not name an
/// object.
std::optional<std::vector<std::string>> choicesOf(const Scene& scene, const Field& field);

}  // namespace keyblock
