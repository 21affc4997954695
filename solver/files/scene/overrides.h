// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `--set path=value`: changes single values of a scene before it is read, so that the
// changed scene passes the same checks as one from a file.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/problem.h"

#include <span>
#include <string>
#include <vector>

namespace keyblock {

/// Sets each `path=value` in the tree, in order. Missing objects along the path are created; list items must exist. The
/// value set by `overrides[i]` gets the line number −1 − i, by which `nameOrigins` identifies the option.
void applyOverrides(JsonNode& root, std::span<const std::string> overrides, std::vector<Problem>& problems);

/// Sets the origin of every problem: the option that set the value or, if no option did, `file`.
void nameOrigins(std::vector<Problem>& problems, const std::string& file, std::span<const std::string> overrides);

}  // namespace keyblock
