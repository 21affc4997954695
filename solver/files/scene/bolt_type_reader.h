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

/// Reads an object whose members are bolt types, and resolves `like`, looking first among these types and then in
/// `library`. A circular `like` or a missing type is reported as a problem; the type then starts from the defaults.
std::vector<BoltType> readBoltTypes(const JsonNode& node, const std::vector<BoltType>& library,
                                    const std::string& pointer, std::vector<Problem>& problems);

}  // namespace keyblock
