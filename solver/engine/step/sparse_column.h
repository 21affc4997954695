// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sparse vector for rank-one updates of a factor.
#pragma once

#include <utility>
#include <vector>

namespace keyblock {

/// Non-zero entries of a vector as (row, value), in any order, each row at most once.
using SparseColumn = std::vector<std::pair<int, double>>;

}  // namespace keyblock
