// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The figures of a sweep as files, in the folder `figures` of it. The header does not
// need Qt.
#pragma once

#include "solver/study/sweep_results.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

struct WrittenFigures {
    long count = 0;
    std::vector<std::string> leftOut;  // names of figures that cannot be drawn, each with the reason
};

/// Draws a histogram and a tornado of each result, each result against the input with which it is most correlated, the
/// given pairs, and the convergence of the probability of failure. \throws CannotWrite
WrittenFigures writeSweepFigures(const SweepResults& results, const Sweep& sweep, const std::vector<ColumnPair>& pairs);

/// Writes the tables and figures of the finished cases into the folder of their sweep, as `keyblock sweep collect` does.
/// \throws CannotRead, CannotWrite
void collectSweep(const std::filesystem::path& folder);

}  // namespace keyblock
