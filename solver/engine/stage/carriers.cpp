// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/carriers.h"

#include <algorithm>
#include <cassert>

namespace keyblock {

const Carrier* carrierOf(LinkKind kind) {
    const auto owner = std::find_if(carriers.begin(), carriers.end(), [&](const Carrier* carrier) {
        return carrier->ownsLink && carrier->ownsLink(kind);
    });
    return owner == carriers.end() ? nullptr : *owner;
}

const Carrier& carrierOf(LimitKind kind) {
    const auto owner = std::find_if(carriers.begin(), carriers.end(), [&](const Carrier* carrier) {
        return carrier->ownsLimit && carrier->ownsLimit(kind);
    });
    assert(owner != carriers.end());
    return **owner;
}

}  // namespace keyblock
