// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes figures, tables and animations of a run to files, for the export of the
// window.
#pragma once

#include "solver/results/tables.h"
#include "ui/figure/figure.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <vector>

namespace keyblock {

/// The user stopped the export.
struct ExportStopped : std::exception {};

/// Whether a figure uses charts, which only the window's thread may create.
bool hasCharts(FigureKind kind);

/// Writes the figure and, `withData`, its data as CSV files next to it. Returns the names of the files. \throws
/// CannotDraw, CannotWrite
std::vector<std::filesystem::path> writeFigureFiles(const RunSource& run, const FigureRequest& request, bool withData,
                                                    const std::filesystem::path& out);

/// \throws CannotWrite
void writeTableFile(const RunSource& run, TableKind kind, const TableFilter& filter, const std::filesystem::path& out);

/// Whether a table is of one frame, and not of the whole run.
bool isOfFrame(TableKind kind);

/// The frame that a filter selects, as "frame 12 of 67, stage burst at 0.052 s"; empty without frames.
std::string frameText(const RunSource& run, const TableFilter& filter);

/// Writes sections of all frames as .mp4 or .webm, or as PNG files into a folder, whose name has no extension. `done`
/// is called after each frame. \throws CannotDraw, CannotWrite, ExportStopped
void writeFilm(const RunSource& run, const FigureRequest& request, int perSecond, const std::filesystem::path& out,
               const std::atomic<bool>& stop, const std::function<void(std::size_t, std::size_t)>& done);

}  // namespace keyblock
