// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help page of the limits of the method, made from the runs at the extremes.
#pragma once

#include "solver/verify/extremes/extremes.h"

#include <string>
#include <vector>

namespace keyblock {

/// The page as Markdown.
/// \param cases all cases with their runs. \param random random combinations, one entry per seed.
std::string limitsPage(const std::vector<ExtremeCaseRuns>& cases, const std::vector<RandomExtremes>& random);

}  // namespace keyblock
