// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/carriers.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace keyblock {

namespace {

constexpr std::size_t linkKinds = static_cast<std::size_t>(LinkKind::Drag) + 1;

std::array<const Carrier*, linkKinds> ownersOfLinks() {
    std::array<const Carrier*, linkKinds> owners{};
    for (std::size_t kind = 0; kind < linkKinds; ++kind) {
        const auto owner = std::find_if(carriers.begin(), carriers.end(), [&](const Carrier* carrier) {
            return carrier->ownsLink && carrier->ownsLink(static_cast<LinkKind>(kind));
        });
        if (owner != carriers.end()) owners[kind] = *owner;
    }
    return owners;
}

}  // namespace

const Carrier* carrierOf(LinkKind kind) {
    static const std::array<const Carrier*, linkKinds> owners = ownersOfLinks();
    return owners[static_cast<std::size_t>(kind)];
}

const Carrier& carrierOf(LimitKind kind) {
    const auto owner = std::find_if(carriers.begin(), carriers.end(), [&](const Carrier* carrier) {
        return carrier->ownsLimit && carrier->ownsLimit(kind);
    });
    assert(owner != carriers.end());
    return **owner;
}

}  // namespace keyblock
