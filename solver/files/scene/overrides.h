// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `--set path=value`: single values of a scene changed from outside, before it
// is read, so that a changed scene passes the same checks as a written one.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/problem.h"

#include <span>
#include <string>
#include <vector>

namespace keyblock {

/// Sets each `path=value` in the tree, in order. Objects on the way that are missing are made; list elements must be
/// there. What is set bears the line −1 − its index, so that `nameOrigins` can name the option.
void applyOverrides(JsonNode& root, std::span<const std::string> overrides, std::vector<Problem>& problems);

/// Gives every problem its file, or the option that set the value.
void nameOrigins(std::vector<Problem>& problems, const std::string& file, std::span<const std::string> overrides);

}  // namespace keyblock
