// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the command `export` that writes figures.
#pragma once

#include "app/cli/cli_commands.h"
#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"

namespace keyblock::cli {

/// Writes the figure and, next to it, a file with its data; also reports problems in reference files.
/// \pre `options.figure` is set.
/// \throws UsageError if the figure cannot be drawn, or if the program was built without figures.
ExitCode exportFigure(const ExportOptions& options, const RunSource& run, const TableFilter& filter);

/// Checks the options that can be checked without the run. \throws UsageError if one is invalid, or if the program was
/// built without figures.
void checkFigureOptions(const ExportOptions& options);

}  // namespace keyblock::cli
