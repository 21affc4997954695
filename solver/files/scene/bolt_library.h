// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolt types that come with the program: data files in resources/bolts, embedded
// in the program when it is built, with a source for each number. Brands of bolts are
// data; the engine only knows laws.
#pragma once

#include "solver/scene/scene.h"

#include <string_view>
#include <vector>

namespace keyblock {

/// All built-in bolt types, sorted by name, with every `like` resolved (bolt_type_reader.h). They are read once, on
/// first use.
const std::vector<BoltType>& builtInBoltTypes();

/// The built-in type with this name; null if there is none.
const BoltType* findBuiltInBoltType(std::string_view name);

/// For a scene built in code: adds the built-in types that its bolts and bolt patterns use but the scene does not
/// define.
void addUsedBuiltInBoltTypes(Scene& scene);

}  // namespace keyblock
