// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contacts as force carriers. A corner facing an edge has two links: normal, with the
// gap as strain, and friction, with the slip as strain.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Adds the links of the contacts, in the order of the state's contacts: normal, then friction. Directions and lever
/// arms are evaluated at the block positions predicted from the current velocities for the time `ahead` [s] or, if
/// `path` is given, halfway along it.
/// \param frictionLocked true to prevent sliding.
void addContactLinks(const Model& model, const State& state, bool frictionLocked, StepProblem& problem,
                     double ahead = 0.0, const Eigen::VectorXd* path = nullptr);

/// Force carrier of the contacts.
extern const Carrier contactCarrier;

}  // namespace keyblock
