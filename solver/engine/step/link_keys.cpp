// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/link_keys.h"

namespace keyblock {

std::uint64_t keyOf(const Link& link) {
    std::uint64_t key = 0;
    const auto mix = [&](std::uint64_t part) {
        key = (key ^ part) * 0x9E3779B97F4A7C15u;
        key ^= key >> 29;
    };
    mix(static_cast<std::uint64_t>(link.kind));
    mix(static_cast<std::uint64_t>(link.a) + 1);
    mix(static_cast<std::uint64_t>(link.b) + 1);
    mix(ofContact(link.kind) ? link.features : static_cast<std::uint64_t>(link.owner) + 1);
    mix(static_cast<std::uint64_t>(link.part) + 1);
    return key;
}

}  // namespace keyblock
