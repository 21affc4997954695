// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of the command `export` that writes animations.
#pragma once

#include "app/cli/cli_commands.h"
#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"

namespace keyblock::cli {

/// Writes a video, or a folder of PNG images with a table of their times. \pre `options.animation` is set.
/// \throws UsageError if the animation cannot be drawn, or if the program was built without figures.
ExitCode exportAnimation(const ExportOptions& options, const RunSource& run, const TableFilter& filter);

/// Checks the options that can be checked without the run. \throws UsageError if one is invalid, or if the program was
/// built without figures.
void checkAnimationOptions(const ExportOptions& options);

}  // namespace keyblock::cli
