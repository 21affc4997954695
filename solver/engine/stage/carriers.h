// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of all force carriers. A new kind of carrier, such as a lining, is one more
// row.
#pragma once

#include "solver/engine/boundary.h"
#include "solver/engine/bolt/bolt.h"
#include "solver/engine/contact/links.h"
#include "solver/engine/damping.h"
#include "solver/engine/glue.h"
#include "solver/engine/support.h"

#include <array>

namespace keyblock {

/// All force carriers in the order in which they add links to a step; damping follows the links that it damps. Limits
/// and energies are listed from the last carrier to the first, so that if a bolt and a joint are equally overloaded,
/// the bolt is released first. Summation follows these orders, so results depend on them in the last digit. A carrier
/// that adds nothing in a scene does not affect the results of that scene.
inline constexpr std::array<const Carrier*, 6> carriers{&contactCarrier, &glueCarrier,    &supportCarrier,
                                                        &boltCarrier,    &dampingCarrier, &boundaryCarrier};

/// Carrier that accepts links of this kind; null for links that store nothing in the state.
const Carrier* carrierOf(LinkKind kind);

/// Carrier that releases limits of this kind.
const Carrier& carrierOf(LimitKind kind);

}  // namespace keyblock
