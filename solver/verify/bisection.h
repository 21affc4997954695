// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the limit at which a scene becomes stable. Limit equilibrium gives this
// number directly; with runs it has to be found by bisection.
#pragma once

#include <functional>

namespace keyblock {

/// The argument between `low` and `high` at which `holds` changes from 0 to 1, to within ±½·`width`.
/// \return NaN if `holds(low)` is not 0, `holds(high)` is not 1, or `holds` returns NaN.
double boundaryOf(double low, double high, double width, const std::function<double(double)>& holds);

}  // namespace keyblock
