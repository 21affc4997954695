// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads objects from JSON according to the field table. It checks that all keys are
// known, required keys are present, values have the right kind and fields apply to
// the object that contains them.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/field.h"
#include "solver/scene/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Reads the members of `node` into `target`; fields without a corresponding member keep their values.
/// \param target a struct of the type described by `structure`.
/// \param skipped the keys that the caller reads itself.
void readObject(const JsonNode& node, const Structure& structure, void* target, const std::string& pointer,
                std::vector<Problem>& problems, const std::vector<std::string_view>& skipped = {});

}  // namespace keyblock
