// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exports a run as files for ParaView: one time series each for blocks, bolts and
// contacts.
#pragma once

#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"

#include <filesystem>

namespace keyblock {

/// Writes a folder with `blocks.pvd`, `bolts.pvd` and `contacts.pvd`, each only if the run has such data, and a `.vtp`
/// file for each time. Time is counted from the start of the run, with a duration of 1 for each static stage; each file
/// contains the stage, and the time within the stage, as field data. Of several frames at the same time, only the last
/// is written. The folder appears complete or not at all. It replaces an earlier export, but not a folder with other
/// contents.
/// \param filter selects the frames by stage and time; by default, all times are written.
/// \throws CannotWrite
void writeVtkFolder(const RunSource& run, const TableFilter& filter, const std::filesystem::path& folder);

}  // namespace keyblock
