// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chart of a trade.
#pragma once

#include "solver/trade/trade.h"

#include <filesystem>

namespace keyblock::cli {

/// Writes trade.svg into the folder. A program that was built without figures prints that the chart is left out.
/// \throws CannotWrite
void writeTradeChart(const Trade& trade, const Scene& scene, const std::filesystem::path& folder);

}  // namespace keyblock::cli
