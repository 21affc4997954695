// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures, tables and films of a run into files: what the window's export writes.
#pragma once

#include "solver/results/tables.h"
#include "ui/figure/figure.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <vector>

namespace keyblock {

/// Somebody said stop.
struct ExportStopped : std::exception {};

/// Whether a figure is painted by charts, which only the window's thread may make.
bool hasCharts(FigureKind kind);

/// The figure and, `withData`, its numbers as CSV files next to it. Gives the names of the files.
/// \throws CannotDraw, CannotWrite
std::vector<std::filesystem::path> writeFigureFiles(const RunSource& run, const FigureRequest& request, bool withData,
                                                    const std::filesystem::path& out);

/// \throws CannotWrite
void writeTableFile(const RunSource& run, TableKind kind, const TableFilter& filter, const std::filesystem::path& out);

/// Whether a table shows one frame, and not the whole run.
bool isOfFrame(TableKind kind);

/// The frame that a filter chooses, as "frame 12 of 67, stage burst at 0.052 s"; empty without frames.
std::string frameText(const RunSource& run, const TableFilter& filter);

/// Sections of all frames as .mp4 or .webm, or as PNG files into a folder, whose name has no ending. `done` is called
/// after each picture.
/// \throws CannotDraw, CannotWrite, ExportStopped
void writeFilm(const RunSource& run, const FigureRequest& request, int perSecond, const std::filesystem::path& out,
               const std::atomic<bool>& stop, const std::function<void(std::size_t, std::size_t)>& done);

}  // namespace keyblock
