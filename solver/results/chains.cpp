// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/chains.h"

namespace keyblock {

std::vector<std::vector<std::size_t>> causeChains(std::span<const Event> events) {
    std::vector<std::vector<std::size_t>> chains;
    std::vector<std::size_t> chainOf(events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
        const long cause = events[i].cause;
        const bool caused = cause >= 0 && static_cast<std::size_t>(cause) < i;  // a cause precedes its effect
        chainOf[i] = caused ? chainOf[cause] : chains.size();
        if (!caused) chains.emplace_back();
        chains[chainOf[i]].push_back(i);
    }
    std::erase_if(chains, [](const auto& chain) { return chain.size() < 2; });
    return chains;
}

}  // namespace keyblock
