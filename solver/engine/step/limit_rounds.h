// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Friction limits follow normal forces, which follow friction limits. A step at rest
// is solved in rounds: each under fixed limits, which are then corrected. Taking them
// over as they come need not end where blocks are wedged between steep joints: after
// a few such rounds they are mixed from the last few (theory, "Friction in rounds").
#pragma once

#include "solver/engine/step/step_problem.h"

#include <deque>

namespace keyblock {

/// The rounds of one step.
class LimitRounds {
public:
    /// Ends a round: sets the limits to what the forces at `d` allow.
    void correct(StepProblem& problem, const Eigen::VectorXd& d);

    /// Begins the next one where that did not balance: sets limits that would have changed least in the rounds so far,
    /// as far as the change is linear in them (Anderson's mixing). \return false in the first rounds, which are plain.
    bool mix(StepProblem& problem);

private:
    struct Round {
        Eigen::VectorXd allowed, change;  // [N] per pair: by the forces, and less what was used
    };
    std::deque<Round> rounds_;  // the last few
    int made_ = 0;
};

}  // namespace keyblock
