// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolt types may be `like` others: a scene's own types, or those of the library.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// Reads an object of bolt types by name, `like` followed: own types before those of the `library`.
/// A circle of `like` and a type that is not there are problems; the type then starts from the defaults.
std::vector<BoltType> readBoltTypes(const JsonNode& node, const std::vector<BoltType>& library,
                                    const std::string& pointer, std::vector<Problem>& problems);

}  // namespace keyblock
