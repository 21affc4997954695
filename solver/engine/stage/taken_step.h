// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The last step that was accepted in motion, as it was solved. Its forces are those that
// its inertia balances; at the positions that it led to, the laws give others.
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

struct TakenStep {
    State before;  // where the step began
    StepProblem problem;
    Eigen::VectorXd d;  // displacement over the step, of every unknown
    LoadPoint at;  // loads that the step took
    StepOptions options;  // without path
    Eigen::VectorXd path;  // along which it was solved, where it was known before; empty: it was not
    long step = -1;  // number of the step that it led to; −1: none was taken
};

}  // namespace keyblock
