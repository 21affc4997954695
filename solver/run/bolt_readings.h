// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantities of a bolt as history and frames give them: per bolt, with the
// signs of the tables.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// Value at `s` metres from the far end: of the element that holds the place (a node's place belongs to the element
/// that starts there), or of the nearest node; whole-bolt quantities ignore the place.
double boltValueAt(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity, double s);

/// Value of largest magnitude along the bolt, with its sign.
double boltExtreme(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity);

/// Force along the bolt at which the bond of a node fails, as embedded and clamped now [N]: the peak of its law; 0
/// for an artificial anchor, out of rock, after the loss of the bond, or without limit.
double bondStrengthNow(const AnchorModel& anchor, const BoltMotion& motion, const BoltNode& node);

/// A bolt as a frame keeps it, without the energy it holds. \param origin added to every place.
BoltFrame boltFrame(const BoltModel& bolt, const BoltMotion& motion, const Point& origin);

}  // namespace keyblock
