// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of events: one event caused by the load, and all events that followed from
// it at the same load, each caused by the release of an earlier one.
#pragma once

#include "solver/results/results.h"

#include <cstddef>
#include <span>
#include <vector>

namespace keyblock {

/// Chains of indices into `events`. Each chain begins with an event that no other event caused, followed by all events
/// that this event caused directly or indirectly, in order of time. An event that was not caused by another event and
/// caused none itself is left out.
std::vector<std::vector<std::size_t>> causeChains(std::span<const Event> events);

}  // namespace keyblock
