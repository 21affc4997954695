// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolt types that come with the program: data files in resources/bolts, put
// into the program when it is built, each number with its source. Brands are
// data; the engine knows laws.
#pragma once

#include "solver/scene/scene.h"

#include <string_view>
#include <vector>

namespace keyblock {

/// All built-in types, `like` followed, in the order of their names. Read once, on first use.
const std::vector<BoltType>& builtInBoltTypes();

/// The built-in type of that name; null when there is none.
const BoltType* findBuiltInBoltType(std::string_view name);

/// Adds to a scene built in code the built-in types that its bolts name and it does not define itself.
void addUsedBuiltInBoltTypes(Scene& scene);

}  // namespace keyblock
