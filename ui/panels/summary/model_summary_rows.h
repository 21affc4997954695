// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts of the model summary: what a run would model and why, what it leaves out,
// and the estimated run time and memory.
#pragma once

#include "solver/run/model_summary.h"

#include <QString>

#include <vector>

namespace keyblock {

struct ModelSummaryRow {
    QString what, count, unknowns, why;
    bool leftOut = false;
    bool total = false;
    bool next = false;  // could be left out
};

std::vector<ModelSummaryRow> modelSummaryRows(const ModelSummary& summary);

/// A run time as text, e.g. `1 min 50 s` or `< 1 s`.
QString costText(double seconds);

/// An amount of memory as text, e.g. `210 MB`.
QString memoryText(double bytes);

/// The basis of the estimate (stages, iterations, assumptions), one item per line.
QString estimateDetails(const CostEstimate& estimate);

}  // namespace keyblock
