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

/// All force carriers, in the order in which they add links to a step. Damping comes after the links that it damps.
/// Limits and energies are taken in reverse order, so that a bolt is released before an equally overloaded joint. The
/// order also determines the order of summation, and thus the last digit of results. A carrier that adds nothing in a
/// scene does not affect the results of that scene.
inline constexpr std::array<const Carrier*, 6> carriers{&contactCarrier, &glueCarrier,    &supportCarrier,
                                                        &boltCarrier,    &dampingCarrier, &boundaryCarrier};

/// Carrier that stores the forces and history of links of this kind in the state; null if nothing is stored for them.
const Carrier* carrierOf(LinkKind kind);

/// Carrier of the parts that fail when they reach a limit of this kind.
const Carrier& carrierOf(LimitKind kind);

}  // namespace keyblock
