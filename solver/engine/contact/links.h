// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contacts as carriers of force: a corner before an edge gives two links, the gap
// and the slip.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Links of the contacts, in the order of the state's contacts: normal, then friction. Their directions and lever arms
/// are those where the blocks will be `ahead` [s] at the speed they have; half way, where their path is known.
void addContactLinks(const Model& model, const State& state, bool frictionLocked, StepProblem& problem,
                     double ahead = 0.0, const Eigen::VectorXd* path = nullptr);

/// Links, history, limits and energy of the contacts.
extern const Carrier contactCarrier;

}  // namespace keyblock
