// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records the result of a complete verification for later reports.
#pragma once

#include "solver/verify/verify.h"

#include <cstddef>
#include <span>

namespace keyblock::cli {

/// Writes the record of a complete verification of this build into the user's data folder. If it cannot be written,
/// prints a warning; the verification itself is not affected.
void recordVerification(std::span<const CaseResult> results, std::size_t cases);

}  // namespace keyblock::cli
