// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of the shank: an element between two nodes stretches by its steel's
// curve, bends and shears as a beam, forms hinges and ruptures.
#pragma once

#include "solver/engine/bolt/bolt_step.h"
#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// The curve of the steel in the current stage: the dynamic one where there is one; null without a curve.
const Backbone* steelNow(const BoltModel& bolt, const BoltMotion& motion);

/// How an element is strained where its nodes are now (theory, "The shank").
BeamStrains strainsOf(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Stiffness of the spring that resists an element's p1, and its limit (and p2's) without axial force [N m]; a limit of
/// 0 where it has none.
double bendStiffness(const BoltModel& bolt, int element);
double hingeForce(const BoltModel& bolt, const BoltMotion& motion);

/// That limit under the axial force that the element carried when it was last accepted [N m].
double hingeLimit(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Combined action in an element under its last accepted forces: (N/N_p)² + (Q/Q_p)², and the same + |M|/M_p with
/// M_p = Z·N_p/A; 0 for steel without limit (theory, "Rupture").
struct Utilisation {
    double forces = 0.0, withMoment = 0.0;
};
Utilisation utilisationOf(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Links of an element: axial, the turning of its chord under tension, bending and shear.
void addShankLinks(BoltStep& step, int element);

/// True for those links.
bool ofShank(LinkKind kind);

/// As `Carrier::accept` and `Carrier::relock`, for them.
void acceptShank(const BoltModel& bolt, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);
void relockShank(const BoltModel& bolt, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);

/// True for the limits of an element.
bool ofShank(LimitKind kind);

/// Limits of an element that still hold.
void addShankLimits(const BoltModel& bolt, const BoltMotion& motion, int owner, int element,
                    std::vector<Limit>& limits);

/// The element has yielded, hinges or is ruptured from now on.
void releaseShank(BoltMotion& motion, const Limit& limit);

/// The event of one of its limits, as the forces are now.
EventKind shankEvent(const BoltModel& bolt, const BoltMotion& motion, const Limit& limit);

/// An element that carries no force.
void unloadElement(BoltElementState& element);

}  // namespace keyblock
