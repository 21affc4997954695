// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/run_limit.h"

#include "solver/scene/number_text.h"

namespace keyblock {

std::string RunLimit::message(long steps) const {
    const bool bySteps = stepsReached(steps);
    return "the limit of " + (bySteps ? shortest(*limits_.steps) + " steps" : shortest(*limits_.wallTime) + " s") +
           " is reached; raise 'limits." + (bySteps ? "steps" : "wall_time") + "' to go further";
}

}  // namespace keyblock
