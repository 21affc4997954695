// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a summary says first: whether it is stable, which blocks are not, which
// joints and bolts failed there, and how well the numbers behind that balance.
#pragma once

#include "solver/results/run_source.h"

#include <string>

namespace keyblock::cli {

std::string verdictText(const RunSource& run);

}  // namespace keyblock::cli
