// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A census in words: what a run would model and why, what it leaves out, what it
// may cost.
#pragma once

#include "solver/run/census.h"

#include <QString>

#include <vector>

namespace keyblock {

struct CensusRow {
    QString what, count, unknowns, why;
    bool leftOut = false;
    bool total = false;
};

std::vector<CensusRow> censusRows(const Census& census);

/// `1 min 50 s`, `< 1 s`.
QString costText(double seconds);

/// `210 MB`.
QString memoryText(double bytes);

/// On what the estimate rests: stages, passes, assumptions; a line each.
QString estimateDetails(const CostEstimate& estimate);

}  // namespace keyblock
