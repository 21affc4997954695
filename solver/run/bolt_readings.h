// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolt quantities for history rows and frames: per bolt, with the sign convention
// of the tables.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// Value of a quantity at the distance `s` [m] from the far end. A quantity of elements is read from the element at `s`
/// (at a node: from the element that starts there), a quantity of nodes from the nearest node. A quantity of the whole
/// bolt does not depend on `s`.
double boltValueAt(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity, double s);

/// Signed value of largest magnitude of a quantity along the bolt.
double boltExtreme(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity);

/// Axial force [N] at which the bond of a node fails at its current embedment and confinement, i.e. the peak of the
/// bond law. It is 0 for an artificial anchor, for a node outside the rock, after the bond has failed, and if the bond
/// has no limit.
double bondStrengthNow(const AnchorModel& anchor, const BoltMotion& motion, const BoltNode& node);

/// A bolt in the form stored in a frame, without its elastic energy.
/// \param origin the point added to all positions.
BoltFrame boltFrame(const BoltModel& bolt, const BoltMotion& motion, const Point& origin);

}  // namespace keyblock
