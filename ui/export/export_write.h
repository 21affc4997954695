// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes figures, tables and animations of a run to files, for the export window.
#pragma once

#include "solver/results/tables.h"
#include "ui/figure/figure.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <vector>

namespace keyblock {

/// Thrown if the user stops the export.
struct ExportStopped : std::exception {};

/// Writes a figure and, if `withData` is set, its data as CSV files next to it. Returns the paths of the files. If the
/// figure is a new file, its data replace no other file; if it replaces an earlier one, its data replace those of it.
/// \throws CannotDraw, CannotWrite, for a run store or a scene too; nothing is written then.
std::vector<std::filesystem::path> writeFigureFiles(const RunSource& run, const FigureRequest& request, bool withData,
                                                    const std::filesystem::path& out);

/// Writes a table to a file. \throws CannotWrite, for a run store or a scene too
void writeTableFile(const RunSource& run, TableKind kind, const TableFilter& filter, const std::filesystem::path& out);

/// True if the table describes one frame; false if it describes the whole run.
bool isOfFrame(TableKind kind);

/// Text that names the frame selected by the filter, e.g. "frame 12 of 67, stage burst at 0.052 s"; empty if the run
/// has no frame that matches the filter.
std::string frameText(const RunSource& run, const TableFilter& filter);

/// Writes the section at every frame. The output is an .mp4 or .webm animation or, if `out` has no extension, a folder
/// of PNG files.
/// \param perSecond frames per second of an animation
/// \param stop set by the caller to stop the export
/// \param done called after each frame with the number of frames written and the number of all frames
/// \throws CannotDraw, CannotWrite (for a run store or a scene too), ExportStopped
void writeFilm(const RunSource& run, const FigureRequest& request, int perSecond, const std::filesystem::path& out,
               const std::atomic<bool>& stop, const std::function<void(std::size_t, std::size_t)>& done);

}  // namespace keyblock
