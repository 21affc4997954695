// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step solved for the forces of its contacts instead of the places of its blocks.
// A place off by 1e-10 m flips a contact; a force off by as small a share does not:
// so the forces say which contacts hold and which slide where Newton's line search
// only stumbles from one change of state to the next.
//
// Gauss–Seidel sweeps over the links, each force set to what its law gives where the
// bodies yield by their own inertia and elasticity, friction limited by the present
// normal force (Jourdan, Alart and Jean 1998); successive sweeps, all in one
// direction, are combined by Anderson's mixing (1965). The bodies balance at every
// moment. Links of bolt nodes, which weigh too little to be held that way, keep the
// force they have at the trial that the sweeps start from.
#pragma once

#include "solver/engine/step/step_matrix.h"
#include "solver/engine/step/swept_links.h"
#include "solver/engine/step/trial.h"

#include <optional>
#include <vector>

namespace keyblock {

class DualSweeps {
public:
    /// \param carried forces to begin from, as of `carriedForces`.
    DualSweeps(StepProblem& problem, const LinkRows& rows, const std::vector<double>& carried);

    /// Forces that the links carry where the step begins, under the friction limits that they have, before shares [N].
    static std::vector<double> carriedForces(const StepProblem& problem, const LinkRows& rows);

    /// True where there are contacts whose states the sweeps can find, and every body can be moved by its own stiffness
    /// alone, which they need.
    bool possible() const { return possible_; }

    /// Sweeps from the forces of the last time (at first those given), then solves for the displacement under the states
    /// that the forces say. Friction limits are left to the next judgement.
    /// \param from where the step was judged last; its forces of bolts are kept.
    /// \return the displacement (padded), or nothing where the matrix is singular.
    std::optional<Eigen::VectorXd> solve(const Trial& from, StepMatrix& matrix, StepWork& work);

private:
    /// What a law is taken as while the states stay.
    struct Straight {
        double force = 0.0, tangent = 0.0, strain = 0.0;
        double sliding = 0.0;  // ±1 where the force is ± the limit

        double at(double e) const { return force + tangent * (e - strain); }
    };

    void sweepUntilSettled(StepWork& work);
    void holdTheRest(const Trial& from);
    Straight straight(std::size_t row) const;
    bool straighten(StepMatrix& matrix, StepWork& work);
    void takeForces(const std::vector<double>& strains);

    StepProblem& problem_;
    const LinkRows& rows_;
    SweptLinks swept_;
    bool possible_ = true;
    std::vector<double> forces_;  // of the swept links, before shares
    std::vector<char> isSwept_;  // per link
    std::vector<Straight> laws_;  // of every link, after the last sweep
};

}  // namespace keyblock
