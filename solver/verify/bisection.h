// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a scene begins to hold: the number that limit equilibrium gives in one
// go, a run only by trying.
#pragma once

#include <functional>

namespace keyblock {

/// Where `holds` changes from 0 at `low` to 1 at `high`, to within ±½·`width`; NaN where it does not or is NaN itself.
double boundaryOf(double low, double high, double width, const std::function<double(double)>& holds);

}  // namespace keyblock
