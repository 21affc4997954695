// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/run_limit.h"

#include "solver/scene/number_text.h"

namespace keyblock {

std::string RunLimit::message(long steps) const {
    const bool bySteps = stepsReached(steps);
    if (bySteps)
        return "the limit of " + shortest(*limits_.steps) + " steps is reached; raise 'limits.steps' to go further";
    return "the limit of " + shortest(*limits_.wallTime) +
           " s is reached; resumed, the run goes on for as long again; with a larger 'limits.wall_time' it begins anew";
}

}  // namespace keyblock
