// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures of a sweep, in the folder `figures` of it.
#pragma once

#include "solver/study/sweep_results.h"

#include <string>
#include <vector>

namespace keyblock::cli {

/// Two columns of the results, one against the other.
struct ScatterPair {
    const SweepColumn *x = nullptr, *y = nullptr;
};

/// Reads pairs `X,Y` of column names. \throws UsageError if a column does not exist
std::vector<ScatterPair> scatterPairs(const std::vector<std::string>& texts, const SweepResults& results);

/// Draws a histogram and a tornado of each result, each result against the input with which it is most correlated, the
/// given pairs, and the convergence of the probability of failure. \return the number of figures; 0 in a program without
/// figures. \throws CannotWrite
long writeSweepFigures(const SweepResults& results, const Sweep& sweep, const std::vector<ScatterPair>& pairs);

}  // namespace keyblock::cli
