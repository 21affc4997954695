// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of everything that carries force. A new law or a lining is one more row.
#pragma once

#include "solver/engine/boundary.h"
#include "solver/engine/bolt/bolt.h"
#include "solver/engine/contact/links.h"
#include "solver/engine/damping.h"
#include "solver/engine/glue.h"
#include "solver/engine/support.h"

#include <array>

namespace keyblock {

/// In the order of their links in a step. Damping comes after all links that it damps. Limits and energies are listed
/// from the last row to the first, so that of equal overloads a bolt's is released before a joint's. Sums follow these
/// orders, and results depend on them to the last digit; a row that adds nothing in a scene changes nothing there.
inline constexpr std::array<const Carrier*, 6> carriers{&contactCarrier, &glueCarrier,    &supportCarrier,
                                                        &boltCarrier,    &dampingCarrier, &boundaryCarrier};

/// The carrier that accepts links of this kind; null for links that leave nothing in the state.
const Carrier* carrierOf(LinkKind kind);

/// The carrier that releases limits of this kind.
const Carrier& carrierOf(LimitKind kind);

}  // namespace keyblock
