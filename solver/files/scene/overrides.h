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
#include <string_view>
#include <vector>

namespace keyblock {

/// The keys along a path, which is written as `stages[0].increments`, as `stages/0/increments` or as a JSON pointer.
std::vector<std::string> keysOfPath(std::string_view path);

/// Sets each `path=value` in the tree, in order. Missing objects along the path are created; list items must exist, and
/// are given by number or, if they have names, by name. The
/// value set by `overrides[i]` gets the line number −1 − i, by which `nameOrigins` identifies the option.
void applyOverrides(JsonNode& root, std::span<const std::string> overrides, std::vector<Problem>& problems);

/// Sets the origin of every problem: the option that set the value or, if no option did, `file`.
void nameOrigins(std::vector<Problem>& problems, const std::string& file, std::span<const std::string> overrides);

}  // namespace keyblock
