// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table and the page of a trade.
#pragma once

#include "solver/trade/trade.h"

#include <ostream>
#include <string>

namespace keyblock {

/// Error up to which settings are recommended.
inline constexpr double recommendedError = 0.03;

/// Writes trade.csv: one row for each point and quantity.
void writeTradeTable(const Trade& trade, const Scene& scene, std::ostream& out);

/// The page trade.md: the recommended settings with one sentence to quote, all points in order of their time, how each
/// quantity converges, and what was not run.
std::string tradePage(const Trade& trade, const Scene& scene);

}  // namespace keyblock
