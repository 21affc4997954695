// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sparse vector, as ranks are added to a factor by.
#pragma once

#include <utility>
#include <vector>

namespace keyblock {

/// The entries of a vector that differ from zero: row and value, in any order, no row twice.
using SparseColumn = std::vector<std::pair<int, double>>;

}  // namespace keyblock
