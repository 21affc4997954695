// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/limits.h"

#include "solver/engine/stage/carriers.h"

#include <algorithm>

namespace keyblock {

std::vector<Limit> heldLimits(const Model& model, const State& state) {
    std::vector<Limit> limits;
    for (auto carrier = carriers.rbegin(); carrier != carriers.rend(); ++carrier)
        if ((*carrier)->addLimits) (*carrier)->addLimits(model, state, limits);
    return limits;
}

std::optional<Limit> worstLimit(const std::vector<Limit>& limits, double least) {
    double largest = 0.0;
    for (const Limit& limit : limits) largest = std::max(largest, limit.ratio);
    if (largest < least) return std::nullopt;
    for (const Limit& limit : limits)
        if (limit.ratio >= largest * (1.0 - tieShare)) return limit;
    return std::nullopt;
}

bool changesForces(const Model& model, const Limit& limit) {
    return carrierOf(limit.kind).changesForces(model, limit);
}

std::vector<Event> releaseLimit(const Model& model, State& state, const Limit& limit) {
    return carrierOf(limit.kind).release(model, state, limit);
}

}  // namespace keyblock
