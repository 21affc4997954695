// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads bolt types. A type may be defined as `like` another type, which is one of the
// scene's own types or of the library.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// Reads a JSON object whose members are bolt types. The type named by `like` is looked up first among these members,
/// then in `library`. A circular `like` or an unknown name is reported as a problem; the type with this `like` then
/// starts from the defaults.
std::vector<BoltType> readBoltTypes(const JsonNode& node, const std::vector<BoltType>& library,
                                    const std::string& pointer, std::vector<Problem>& problems);

}  // namespace keyblock
