// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A warning that commands which read a run store have in common.
#pragma once

#include "solver/files/run_store/run_store.h"

#include <filesystem>

namespace keyblock::cli {

/// Warns on standard error if the store was copied without its write-ahead file, so that results may be missing.
void warnOfMissingResults(const RunStore& store, const std::filesystem::path& path);

}  // namespace keyblock::cli
