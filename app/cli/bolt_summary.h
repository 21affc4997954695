// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run did to its bolts: their largest forces and use, the chains of
// failures, and the energy of each bolt.
#pragma once

#include "solver/results/run_source.h"

#include <string>
#include <vector>

namespace keyblock::cli {

/// What an event was and where, as in `debonding of B at node 12`.
std::string eventPhrase(const RunSource& run, const Event& event);

/// A line for every chain of causes, the longest ones shortened; empty without any.
std::string chainLines(const RunSource& run, const std::vector<Event>& events);

/// The largest forces of every bolt over the run, the use of its strengths, what governs and what it holds; of the
/// bolts with the highest use where there are many. Empty without bolts or frames.
std::string boltUseTable(const RunSource& run);

/// Energies of the bolts in the last frame, of those with the most where there are many; empty without bolts or frames.
std::string boltEnergyTable(const RunSource& run);

}  // namespace keyblock::cli
