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
#include "solver/engine/step/trial.h"

#include <optional>
#include <vector>

namespace keyblock {

class DualSweeps {
public:
    /// \param carried forces to begin from, as of `carriedForces`.
    DualSweeps(StepProblem& problem, const LinkRows& rows, std::vector<double> carried);

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
    struct Visit {
        int link = -1, pair = -1;  // pair: row of limitPairs that limits the link; −1: none
    };
    /// What a law is taken as while the states stay.
    struct Straight {
        double force = 0.0, tangent = 0.0, strain = 0.0;
        double sliding = 0.0;  // ±1 where the force is ± the limit

        double at(double e) const { return force + tangent * (e - strain); }
    };

    /// Squares of the forces and of their changes, summed over a sweep.
    struct Change {
        double changed = 0.0, forces = 0.0;
    };

    void findOrder();
    void findCompliances();
    void place(Eigen::VectorXd& d) const;
    Change sweep(Eigen::VectorXd& d);
    double settle(std::size_t link, double free);
    void sweepUntilSettled(StepWork& work);
    void clip(std::vector<double>& forces);
    void limit(int pair);
    void holdTheRest(const Trial& from);
    Straight straight(std::size_t link) const;
    bool straighten(const Trial& from, StepMatrix& matrix, StepWork& work);
    void takeForces(const std::vector<double>& strains);
    double weightOf(const Link& link) const { return ofContact(link.kind) ? problem_.contactShare : 1.0; }

    StepProblem& problem_;
    const LinkRows& rows_;
    bool possible_ = true;
    std::vector<Visit> order_;  // normal force before its friction
    std::vector<char> swept_;  // per link; 0: of a bolt node
    std::vector<Matrix6> inverse_;  // per block; rows and columns of prescribed unknowns are zero
    std::vector<double> yields_;  // K⁻¹·g of every link, twelve entries
    std::vector<double> compliance_;  // share·gᵀK⁻¹g of every link
    std::vector<double> force_, strain_;  // of every link, before its share, and where its law gives it
    std::vector<Straight> laws_;  // of every link, after the last sweep
    Eigen::VectorXd outer_;  // loads and forces of links that are not swept, less those of prescribed moves
};

}  // namespace keyblock
