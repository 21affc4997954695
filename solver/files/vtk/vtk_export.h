// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run as files that ParaView opens: one time series each of blocks, bolts and
// contacts.
#pragma once

#include "solver/results/run_source.h"
#include "solver/results/table_filter.h"

#include <filesystem>

namespace keyblock {

/// Writes the folder `blocks.pvd`, `bolts.pvd`, `contacts.pvd` (those that the run has anything for) with a `.vtp` file
/// for each moment next to them. Time counts from the start of the run, a static stage as 1; stage and time within it
/// are in each file as field data. The filter's stage and moment select; by default every moment is written. Of
/// frames that share a moment the last counts. The folder appears whole or not at all; an older export is replaced,
/// a folder with anything else in it is not. \throws CannotWrite
void writeVtkFolder(const RunSource& run, const TableFilter& filter, const std::filesystem::path& folder);

}  // namespace keyblock
