// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What led to what: one event that the load brought about, and all that followed
// from it at the same load, each set over by the release of another.
#pragma once

#include "solver/results/results.h"

#include <cstddef>
#include <span>
#include <vector>

namespace keyblock {

/// Numbers of events, each list beginning with one that no event caused and going on with those that it caused,
/// straight or through others, in their order. Events that led to nothing and came of nothing are in no list.
std::vector<std::vector<std::size_t>> causeChains(std::span<const Event> events);

}  // namespace keyblock
