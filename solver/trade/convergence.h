// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Judges from the values of a quantity on finer and finer discretizations whether it
// converges as theory says, so that its limit can be extrapolated, or scatters.
#pragma once

#include <span>

namespace keyblock {

/// A value of a quantity on a discretization.
struct SizedValue {
    double size = 0.0;  // of the discretization, > 0, smaller for finer ones
    double value = 0.0;
};

/// Orders that theory gives for the error: the lowest where the solution has kinks (debonding, sliding, yield), the
/// highest where it is smooth.
struct TheoreticalOrders {
    double lowest = 1.0, highest = 2.0;
};

/// How a quantity converges along an axis.
struct ConvergenceOrder {
    enum class Kind { Regular, NoEffect, Irregular, Unknown };
    Kind kind = Kind::Unknown;  // unknown: fewer than three values
    double order = 0.0;  // of the size, if regular
    double limit = 0.0;  // value extrapolated to size 0 (Richardson 1911), if regular
    double scatter = 0.0;  // range of the three finest values, if irregular [as the quantity]
};

/// Judges a quantity by its three finest values. It is regular if their differences have one sign, also with the next
/// coarser value if there is one, and shrink with an order between half of the lowest of theory and twice the highest;
/// otherwise an extrapolation means nothing (Roache 1998; Oberkampf & Roy 2010), and the range of the three values is
/// how far any of them may be off (Eça & Hoekstra 2014). So it is where they seem to converge faster than theory
/// allows: that may be the crest of an oscillation.
/// \param values from fine to coarse; each size is larger than that before it.
ConvergenceOrder convergenceOf(std::span<const SizedValue> values, TheoreticalOrders theory);

}  // namespace keyblock
