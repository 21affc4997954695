// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/bisection.h"

#include <cmath>

namespace keyblock {

double boundaryOf(double low, double high, double width, const std::function<double(double)>& holds) {
    if (holds(low) != 0.0 || holds(high) != 1.0) return std::nan("");
    while (high - low > width) {
        const double middle = 0.5 * (low + high), found = holds(middle);
        if (std::isnan(found)) return found;
        (found == 1.0 ? high : low) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace keyblock
