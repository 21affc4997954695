// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What of a bolt can let go: its share in `limits.h`, apart from the joints of
// the rock.
#pragma once

#include "solver/engine/stage/limits.h"

namespace keyblock {

/// Limits of one bolt, node by node with the element that starts there, then the plate.
void addBoltLimits(const Model& model, const State& state, int bolt, std::vector<Limit>& limits);

/// As `changesForces`, for a limit of a bolt.
bool boltChangesForces(const Model& model, const Limit& limit);

/// As `releaseLimit`, for a limit of a bolt.
std::vector<Event> releaseBolt(const Model& model, State& state, const Limit& limit);

/// An event of a node or an element as the bolt is now.
Event boltEvent(const Model& model, const State& state, const Limit& limit, EventKind kind);

/// Force along the slot at which a bonded anchored point lets go [N]; none for a law without one.
std::optional<double> bondStrength(const AnchorModel& anchor, const BoltNode& node, double strengthFactor);

/// Combined action in an element under its last accepted forces: (N/N_p)² + (Q/Q_p)², and the same + |M|/M_p with
/// M_p = Z·N_p/A; 0 for steel without limit (theory, "Rupture").
struct Utilisation {
    double forces = 0.0, withMoment = 0.0;
};
Utilisation utilisationOf(const BoltModel& bolt, const BoltMotion& motion, int element);

}  // namespace keyblock
