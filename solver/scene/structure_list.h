// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tables below a table, for references made from them.
#pragma once

#include "solver/scene/field.h"

#include <vector>

namespace keyblock {

/// A table and all tables below it. Each is listed once, in depth-first order of the rows that refer to it.
std::vector<const Structure*> structuresFrom(const Structure& root);

}  // namespace keyblock
