// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Objects from JSON by the field table: keys known, required ones there, values
// of the right kind, fields where they belong.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/field.h"
#include "solver/scene/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Reads the members of `node` over what `target` holds; keys in `skipped` are left to the caller.
/// `target` is a struct of the type that `structure` describes.
void readObject(const JsonNode& node, const Structure& structure, void* target, const std::string& pointer,
                std::vector<Problem>& problems, const std::vector<std::string_view>& skipped = {});

}  // namespace keyblock
