// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of `export` that writes animations.
#pragma once

#include "app/cli/cli_commands.h"
#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"

namespace keyblock::cli {

/// Writes a video, or a folder of PNG images with a table of their times. \pre `options.animation` is set.
/// \throws UsageError for what cannot be drawn, and in a build without figures.
ExitCode exportAnimation(const ExportOptions& options, const RunSource& run, const TableFilter& filter);

/// Throws the usage errors that need no run.
void checkAnimationOptions(const ExportOptions& options);

}  // namespace keyblock::cli
