// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/run_limit.h"

#include "solver/scene/number_text.h"

#include <cassert>

namespace keyblock {

std::string RunLimit::message(long steps) const {
    assert(reached(steps));
    const bool bySteps = stepsReached(steps);
    if (bySteps)
        return "the limit of " + shortest(*limits_.steps) + " steps was reached; raise 'limits.steps' to continue";
    return "the limit of " + shortest(*limits_.wallTime) +
           " s was reached; if resumed, the run continues for the same time again; with a larger 'limits.wall_time' it "
           "starts from the beginning";
}

}  // namespace keyblock
