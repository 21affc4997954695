// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The change of the contact forces over the last step, from which the sweeps over the
// contact forces begin closer to those at the end of the next one: waves and blocks that
// begin to slide change them in much the same way for several steps.
#pragma once

#include "solver/engine/step/step_problem.h"

#include <cstdint>
#include <vector>

namespace keyblock {

class ForceTrend {
public:
    /// Continues the contact forces: adds to each a fraction of its change from the start of the last step to the start
    /// of this one. Contacts that are not found in the last step keep their forces.
    /// \param forces one per link of the step, at zero displacement; changed in place [N].
    void predict(const StepProblem& problem, std::vector<double>& forces);

    /// Ends a step. After one in which nothing was predicted, the stored forces are those of an earlier step; they are
    /// dropped.
    void endStep();

private:
    std::vector<std::uint64_t> keys_;  // per contact link at the start of the last step
    std::vector<double> forces_;  // the same [N]
    bool isCurrent_ = false;  // they are of the step that is being solved
};

}  // namespace keyblock
