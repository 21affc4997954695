// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of the shank. An element between two nodes elongates according to the
// stress–strain curve of its steel, bends and shears as a beam, forms plastic hinges and
// ruptures.
#pragma once

#include "solver/engine/bolt/bolt_step.h"
#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Stress–strain curve of the steel for the current stage, with dynamic strength where applicable; null for linear
/// steel.
const Backbone* steelNow(const BoltModel& bolt, const BoltMotion& motion);

/// Strains of an element at the current positions of its nodes (theory, "The shank").
BeamStrains strainsOf(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Stiffness 2EI/L of an element's spring for the bending strain p1 (see BeamStrains) [N m/rad].
double bendStiffness(const BoltModel& bolt, int element);
/// Plastic limit of the forces conjugate to the bending strains p1 and p2 at zero axial force [N m]; 0 if the bolt
/// forms no hinges.
double hingeForce(const BoltModel& bolt, const BoltMotion& motion);

/// Plastic limit of the forces conjugate to p1 and p2 under the element's last accepted axial force [N m].
double hingeLimit(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Utilisation of an element under its last accepted axial force N, shear force Q and larger end moment M. `forces` is
/// (N/N_p)² + (Q/Q_p)², with the tensile strength N_p and the shear strength Q_p. `withMoment` is `forces` + |M|/M_p,
/// with M_p = Z·N_p/A, plastic section modulus Z and area A. Both are 0 for steel of unlimited strength (theory,
/// "Rupture").
struct Utilisation {
    double forces = 0.0, withMoment = 0.0;
};
Utilisation utilisationOf(const BoltModel& bolt, const BoltMotion& motion, int element);

/// Adds the links of an element, in this order: axial; rotation of the chord, if the element is in tension; bending and
/// shear, if the bolt can bend.
void addShankLinks(BoltStep& step, int element);

/// True if links of this kind belong to the shank.
bool ofShank(LinkKind kind);

/// Like `Carrier::accept` and `Carrier::relock`, for the links of an element.
void acceptShank(const BoltModel& bolt, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);
void relockShank(const BoltModel& bolt, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);

/// True if limits of this kind belong to the shank.
bool ofShank(LimitKind kind);

/// Adds the limits of an element that have not been released yet. \param owner index of the bolt.
void addShankLimits(const BoltModel& bolt, const BoltMotion& motion, int owner, int element,
                    std::vector<Limit>& limits);

/// Marks an element as yielded, hinged or ruptured, depending on the limit.
void releaseShank(BoltMotion& motion, const Limit& limit);

/// Kind of event for a limit of an element under its current forces.
EventKind shankEvent(const BoltModel& bolt, const BoltMotion& motion, const Limit& limit);

/// Sets all forces of an element to zero.
void unloadElement(BoltElementState& element);

}  // namespace keyblock
