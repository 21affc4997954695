// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves a step for its contact forces instead of its block displacements. A
// displacement error of 1e-10 m can change the state of a contact, whereas an equally
// small relative error of a force does not. The forces therefore show which contacts
// stick and which slide where Newton's line search makes hardly any progress from one
// change of state to the next.
//
// The links are visited in Gauss–Seidel sweeps. Each force is set to the value that
// its law gives as the two bodies respond to it with their own inertia and elasticity;
// friction is limited by the current normal force (Jourdan, Alart and Jean 1998). All
// sweeps run in the same direction; after every second one they are combined by
// Anderson mixing (1965). After each group of links between two bodies, the bodies are
// in equilibrium under the forces. Bolt nodes have too little mass for this method;
// bolts yield with the tangents of the trial from which the sweeps start.
//
// In short time steps inertia is about as stiff as the contacts. The displacement under
// the swept forces is then the solution, and no matrix needs to be factored (not in
// scenes with bolts, whose nodes have no swept forces).
#pragma once

#include "solver/engine/step/anderson.h"
#include "solver/engine/step/step_matrix.h"
#include "solver/engine/step/swept_links.h"
#include "solver/engine/step/trial.h"

#include <optional>
#include <vector>

namespace keyblock {

class DualSweeps {
public:
    /// \param carried the initial forces, from `carriedForces`, possibly continued.
    DualSweeps(StepProblem& problem, const LinkRows& rows, const std::vector<double>& carried);

    /// Force of each link at zero displacement under the current friction limits, not multiplied by `Law::share` [N].
    static std::vector<double> carriedForces(const StepProblem& problem, const LinkRows& rows);

    /// True if sweeps are possible: the problem has contacts, and each block's own stiffness matrix is positive
    /// definite.
    bool possible() const { return possible_; }

    /// Sweeps over the contact forces until they settle. The sweeps start from the forces of the previous solution, at
    /// first from those passed to the constructor. The friction limits are not updated to the displacement.
    /// \param from the trial evaluated last; bolt links keep the tangents that they have in it.
    /// \param tolerance unbalanced force over the acting forces that a displacement may leave.
    /// \return the displacement under the swept forces (padded) if it may leave as little; otherwise nothing.
    std::optional<Eigen::VectorXd> sweep(const Trial& from, double tolerance, StepWork& work);

    /// Continues the sweeps. \pre `sweep` has returned a displacement.
    /// \param share of the last estimate of the unbalanced forces that may remain.
    /// \return the displacement (padded), or nothing if that takes too many sweeps or none can improve it.
    std::optional<Eigen::VectorXd> sweepOn(double share, StepWork& work);

    /// Solves for the displacement with the contact states (sticking, sliding or open) that follow from the swept
    /// forces. \pre `sweep` has been called.
    /// \param from the trial from which the sweeps started.
    /// \return the displacement (padded), or nothing if the matrix is singular.
    std::optional<Eigen::VectorXd> solve(const Trial& from, StepMatrix& matrix, StepWork& work);

private:
    /// Straight line that replaces a law while the contact states are fixed.
    struct Straight {
        double force = 0.0, tangent = 0.0, strain = 0.0;
        double sliding = 0.0;  // ±1 if the force equals ± the friction limit, otherwise 0

        double at(double e) const { return force + tangent * (e - strain); }
    };

    void sweepOnce(StepWork& work);
    bool isSettled() const;
    double mismatch() const;
    std::optional<Eigen::VectorXd> sweepDownTo(double most, StepWork& work);
    void holdTheRest(const Trial& from);
    Straight straight(std::size_t row) const;
    bool straighten(StepMatrix& matrix, StepWork& work);
    void takeForces(const Eigen::VectorXd& d, StepWork& work);

    StepProblem& problem_;
    const LinkRows& rows_;
    SweptLinks swept_;
    bool possible_ = true;
    std::vector<double> forces_;  // per swept link, not multiplied by `Law::share` [N]
    std::vector<char> isSwept_;  // per link
    std::vector<Straight> laws_;  // per link, after the last sweep
    AndersonMixing mixing_;
    SweptLinks::Change last_;  // in the last sweep
    Eigen::VectorXd changes_;  // of the forces in the last sweep [N]
    int made_ = 0;  // number of sweeps since `sweep` was called
};

}  // namespace keyblock
