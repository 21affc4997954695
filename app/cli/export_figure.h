// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of `export` that paints.
#pragma once

#include "app/cli/cli_commands.h"
#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"

namespace keyblock::cli {

/// Writes the figure and, next to it, its data; reports problems of references. \pre `options.figure` is set.
/// \throws UsageError for what cannot be drawn, and in a build without figures.
ExitCode exportFigure(const ExportOptions& options, const RunSource& run, const TableFilter& filter);

/// Throws the usage errors that need no run.
void checkFigureOptions(const ExportOptions& options);

}  // namespace keyblock::cli
