// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Locates the point in an increment at which the first limit is reached. The ratios of
// load to strength are not linear in the load: once something yields or slides they may
// rise a thousand times faster than before. Interpolation across the limit is therefore
// of little use, and the search extrapolates from the side below the limit.
#pragma once

#include "solver/engine/carrier/limit.h"

#include <vector>

namespace keyblock {

/// Bracketing search for the fraction of an increment at which the first limit is reached.
class LimitSearch {
public:
    /// \param low a fraction of the increment at which no limit is exceeded.
    /// \param high a fraction at which a limit is exceeded.
    /// \param atLow, atHigh the limits at these fractions.
    LimitSearch(double low, std::vector<Limit> atLow, double high, std::vector<Limit> atHigh);

    /// Next fraction of the increment to evaluate. It lies between the two ends of the bracket.
    double next();

    /// Stores the limits found at the fraction `share` of the increment.
    /// \param over true if any of these limits is exceeded.
    void take(double share, std::vector<Limit> limits, bool over);

    double high() const { return high_.share; }
    double width() const { return high_.share - low_.share; }

private:
    struct End {
        double share = 0.0;
        std::vector<Limit> limits;
        double weight = 1.0;  // halved while only the other end moves (regula falsi, Illinois)
    };

    double crossing(const Limit& over) const;

    End low_, high_;
    End before_;  // previous low end; no limits: none yet
    int tries_ = 0;
    int moved_ = 0;  // end that moved last: −1 low, 1 high
    double width_;  // width three tries ago
};

}  // namespace keyblock
