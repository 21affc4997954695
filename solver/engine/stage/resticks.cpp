// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/resticks.h"

#include "solver/engine/bolt/anchor.h"
#include "solver/engine/bolt/bolt.h"

#include <algorithm>

namespace keyblock {

std::optional<State> ifSliding(const State& state) {
    for (const BoltMotion& bolt : state.bolts)
        if (std::any_of(bolt.nodes.begin(), bolt.nodes.end(), [](const BoltNode& n) { return n.bond.sliding; }))
            return state;
    return std::nullopt;
}

void reportResticks(const Model& model, const std::optional<State>& before, const State& after, double time,
                    long cause, StepObserver& observer) {
    if (!before) return;
    for (int b = 0; b < static_cast<int>(after.bolts.size()); ++b) {
        if (!acts(after.bolts[b])) continue;
        for (int n = 0; n < static_cast<int>(after.bolts[b].nodes.size()); ++n) {
            if (!sticksAgain(before->bolts[b].nodes[n], after.bolts[b].nodes[n])) continue;
            Event event = boltEvent(model, *before, {LimitKind::Bond, b, n, 0.0}, EventKind::Restick);
            event.cause = cause;
            observer.beforeEvent(*before, time);
            observer.event(event, *before, time);
            observer.afterEvent(*before, time);
        }
    }
}

}  // namespace keyblock
