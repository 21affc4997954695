// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One bolt in a step that is being built: what shank, anchored points and plate
// need in order to add their links.
//
// A spring between a node and the rock acts at the node's own place on both: the
// block's displacement there is T(x)·D. So the pair of forces is collinear and
// gives no couple (the paper's eq. 26 and 30 reach the same to first order).
#pragma once

#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

namespace keyblock {

struct BoltStep {
    BoltStep(const Model& wholeModel, const State& wholeState, int boltIndex, StepProblem& stepProblem);

    /// A link between a node and the block of a slot or plate, along `direction`.
    Link& toRock(LinkKind kind, int node, int block, const Point& direction, double strain, double share);

    /// A link between the two ends of an element.
    Link& ofElement(LinkKind kind, int element, double strain, double share, const Eigen::Vector3d& g1,
                    const Eigen::Vector3d& g2);

    /// Row of the link that was added last.
    int last() const { return static_cast<int>(problem.links.size()) - 1; }

    const Model& model;
    const State& state;
    const BoltModel& bolt;
    const BoltMotion& motion;
    StepProblem& problem;
    int index;
    int firstBody;  // of its nodes among the bodies of the step
};

}  // namespace keyblock
