// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limits: parts that fail when the load on them exceeds their strength. Each force
// carrier lists its limits, and the stages select the one that fails next.
#pragma once

namespace keyblock {

enum class LimitKind {
    Bond, CurveEnd, Yield, Hinge, TensileRupture, ShearRupture, Interaction, Plate,  // of bolts
    JointBond, PeakFriction  // of joints
};

struct Limit {
    LimitKind kind = LimitKind::Bond;
    int owner = -1;  // bolt or contact
    int part = -1;  // node or element of the bolt
    double ratio = 0.0;  // load over strength
};

/// True if `a` and `b` are the same limit of the same part; their ratios may differ.
inline bool sameLimit(const Limit& a, const Limit& b) {
    return a.kind == b.kind && a.owner == b.owner && a.part == b.part;
}

/// Relative difference up to which the ratios of two limits count as equal.
inline constexpr double tieShare = 1e-6;
/// A limit counts as just reached if its ratio exceeds 1 by no more than this value.
inline constexpr double reachedShare = 1e-9;

}  // namespace keyblock
