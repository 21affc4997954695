// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The last accepted dynamic step, as it was solved. Its forces are in equilibrium with
// its inertia, whereas at the positions reached by the step the laws give different
// forces.
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

struct TakenStep {
    State before;  // state at the start of the step
    StepProblem problem;
    Eigen::VectorXd d;  // displacement of every unknown over the step
    LoadPoint at;  // loads used in the step
    StepOptions options;  // without paths
    Eigen::VectorXd path;  // displacement assumed for directions and lever arms; empty: predicted from velocities
    long step = -1;  // step number of the state reached; −1: none yet
};

}  // namespace keyblock
