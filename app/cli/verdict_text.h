// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// First part of the summary of a run: whether the scene is stable, the unstable
// blocks, the joints and bolts that failed around them, and the unbalanced force and
// energy error behind the verdict.
#pragma once

#include "solver/results/run_source.h"

#include <string>

namespace keyblock::cli {

std::string verdictText(const RunSource& run);

}  // namespace keyblock::cli
