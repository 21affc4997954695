// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the links of a step among those of an earlier step. Most links remain from step
// to step in the same order, but contacts come and go.
#pragma once

#include "solver/engine/step/step_problem.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace keyblock {

/// Key that identifies a link from step to step. Contacts are identified by their features, because their numbers
/// change.
std::uint64_t keyOf(const Link& link);

/// Rows with their keys.
using KeyedRows = std::vector<std::pair<std::uint64_t, int>>;

/// Visits the rows with equal keys in two lists that mostly have the same keys in the same order.
/// \param visit called with a row of the first list and a row of the second.
/// \return the other rows of each list, sorted by key.
template <class Visit>
std::pair<KeyedRows, KeyedRows> alignRows(const std::vector<std::uint64_t>& before,
                                          const std::vector<std::uint64_t>& now, const Visit& visit) {
    constexpr std::ptrdiff_t keysAhead = 32;  // number of keys searched ahead
    std::pair<KeyedRows, KeyedRows> others;
    auto next = before.begin();
    const auto leave = [&](auto to) {
        for (; next != to; ++next) others.first.emplace_back(*next, static_cast<int>(next - before.begin()));
    };
    for (std::size_t i = 0; i < now.size(); ++i) {
        const auto end = next + std::min(keysAhead, before.end() - next);
        const auto found = std::find(next, end, now[i]);
        if (found == end) {
            others.second.emplace_back(now[i], static_cast<int>(i));
            continue;
        }
        leave(found);
        visit(static_cast<std::size_t>(next - before.begin()), i);
        ++next;
    }
    leave(before.end());
    std::sort(others.first.begin(), others.first.end());
    std::sort(others.second.begin(), others.second.end());
    return others;
}

}  // namespace keyblock
