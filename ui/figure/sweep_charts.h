// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The charts of a sweep, made from its results. The header does not need Qt.
#pragma once

#include "solver/study/sweep_results.h"
#include "ui/figure/sweep_figure.h"

#include <string>
#include <vector>

namespace keyblock {

/// Whether at least two values of the column differ.
bool isVaried(const SweepColumn& column);

/// Whether the column is a result, and not a value that varies or the verdict.
inline bool isResult(const SweepColumn& column) { return column.role == ColumnRole::Result; }

/// Columns of the parameters and faults that vary.
std::vector<const SweepColumn*> variedInputs(const SweepResults& results);

/// The varied input with the largest rank correlation with a result; null if there is none.
const SweepColumn* strongestInput(const SweepResults& results, const SweepColumn& result);

HistogramChart histogramOf(const std::string& title, const SweepColumn& column);

/// A dot for each case that has both values; cases that fail are marked.
ScatterChart scatterOf(const std::string& title, const SweepResults& results, const ColumnPair& pair);

/// The rank correlations of a result or of the verdict with the varied inputs, largest first.
TornadoChart tornadoOf(const std::string& title, const SweepResults& results, const SweepColumn& column);

ConvergenceChart convergenceChartOf(const std::string& title, const SweepResults& results);

}  // namespace keyblock
