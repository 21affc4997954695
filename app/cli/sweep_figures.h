// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures of a sweep, in the folder `figures` of it.
#pragma once

#include "solver/study/sweep_results.h"

#include <string>
#include <vector>

namespace keyblock::cli {

/// Reads pairs `X,Y` of column names. \throws UsageError if a column does not exist
std::vector<ColumnPair> scatterPairs(const std::vector<std::string>& texts, const SweepResults& results);

/// Draws all figures of a sweep and prints which cannot be drawn. \return the number of figures; 0 in a program without
/// figures. \throws CannotWrite
long drawSweepFigures(const SweepResults& results, const Sweep& sweep, const std::vector<ColumnPair>& pairs);

}  // namespace keyblock::cli
