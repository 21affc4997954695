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

/// Writes a folder with a time series each for blocks, bolts (if the scene has any) and contacts: `blocks.pvd`,
/// `bolts.pvd` and `contacts.pvd`, which list one `.vtp` file per time.
/// Time is counted from the start of the run, and each static stage has a duration of 1. The field data of each `.vtp`
/// file give the stage and the time within the stage.
/// Of several frames at the same time, only the last is written. Exception: two frames of one stage with an event
/// between them are both written, the first at a slightly smaller time.
/// The folder appears complete or not at all. It replaces an earlier export, but not a folder with other contents.
/// \param filter selects the frames by stage and time; by default, all frames are selected.
/// \throws CannotWrite
void writeVtkFolder(const RunSource& run, const TableFilter& filter, const std::filesystem::path& folder);

}  // namespace keyblock
