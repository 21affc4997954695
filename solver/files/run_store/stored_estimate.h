// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The estimated errors of a run, in its store.
#pragma once

#include "solver/results/quantity_estimate.h"

#include <filesystem>
#include <optional>

namespace keyblock {

/// Adds an estimate to the store of a finished run, in place of an earlier one. \throws CannotWrite
void storeEstimate(const std::filesystem::path& store, const ErrorEstimate& estimate);

/// The estimate in a store, if there is one. \throws CannotRead if the file is not a run store or is damaged.
std::optional<ErrorEstimate> storedEstimate(const std::filesystem::path& store);

}  // namespace keyblock
