// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolt results of a run as text: largest forces and utilisation, chains of failures,
// and the energy of each bolt.
#pragma once

#include "solver/results/run_source.h"

#include <string>
#include <vector>

namespace keyblock::cli {

/// Kind and location of an event, as in `debonding of B at node 12`.
std::string eventPhrase(const RunSource& run, const Event& event);

/// Chains of failures, one per line; each event in a chain caused the next. Only the first chains and the first events
/// of each are shown, followed by the number of those omitted. Empty if there are no chains.
std::string chainLines(const RunSource& run, const std::vector<Event>& events);

/// Table of the bolts: largest forces over the run, utilisation of each strength, governing strength and supported
/// blocks. If there are many bolts, only those with the highest utilisation are listed. Empty if the run has no bolts
/// or no frames.
std::string boltUseTable(const RunSource& run);

/// Table of the energies of the bolts in the last frame. If there are many bolts, only those with the highest energies
/// are listed. Empty if the run has no bolts or no frames.
std::string boltEnergyTable(const RunSource& run);

}  // namespace keyblock::cli
