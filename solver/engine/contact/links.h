// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contacts as force carriers. A corner facing an edge has two links: normal, with the
// gap as strain, and friction, with the slip as strain.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Adds the links of the contacts, in the order of the state's contacts; for each contact, the normal link comes before
/// the friction link. Directions and lever arms are evaluated halfway along `path` if it is given, otherwise at the
/// block positions predicted from the current velocities for the time `ahead` [s].
/// \param frictionLocked true to prevent sliding.
void addContactLinks(const Model& model, const State& state, bool frictionLocked, StepProblem& problem,
                     double ahead = 0.0, const Eigen::VectorXd* path = nullptr);

/// Force carrier of the contacts.
extern const Carrier contactCarrier;

}  // namespace keyblock
