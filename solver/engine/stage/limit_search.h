// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where in an increment the first limit is reached. Ratios bend where something
// yields or slides: past a limit they may rise a thousand times faster than
// before it, so a straight line from one side of the limit to the other says
// little, and the search continues from the side that is not over.
#pragma once

#include "solver/engine/carrier/limit.h"

#include <vector>

namespace keyblock {

class LimitSearch {
public:
    /// \param low share of the increment at which no limit is passed, `high` one at which some are.
    LimitSearch(double low, std::vector<Limit> atLow, double high, std::vector<Limit> atHigh);

    /// Share to look at next, within the two.
    double next();

    /// Takes what was found there.
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
    End before_;  // the low end that was left; without limits: none yet
    int tries_ = 0;
    int moved_ = 0;  // the end that moved last: −1 low, 1 high
    double width_;  // three tries ago
};

}  // namespace keyblock
