// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A limit: something that fails when what acts on it exceeds its strength. The
// carriers of force list theirs; the stages pick which one fails next.
#pragma once

namespace keyblock {

enum class LimitKind {
    Bond, CurveEnd, Yield, Hinge, TensileRupture, ShearRupture, Interaction, Plate,  // of bolts
    JointBond, PeakFriction  // of joints
};

struct Limit {
    LimitKind kind = LimitKind::Bond;
    int owner = -1;  // bolt, or contact
    int part = -1;  // node or element
    double ratio = 0.0;  // of load to strength
};

/// True where both limit the same part in the same way, whatever their ratios.
inline bool sameLimit(const Limit& a, const Limit& b) {
    return a.kind == b.kind && a.owner == b.owner && a.part == b.part;
}

/// Shares of a limit within which two overloads are a tie, and to which an event is located.
inline constexpr double tieShare = 1e-6;
inline constexpr double reachedShare = 1e-9;

}  // namespace keyblock
