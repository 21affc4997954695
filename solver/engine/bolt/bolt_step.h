// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One bolt in a step under construction: the data that shank, anchored points and face
// plate need to add their links.
//
// A spring between a node and the rock acts on both at the position of the node, where
// the block's displacement is T(x)·D. The two forces are therefore collinear and form no
// couple (eqs. 26 and 30 of the paper achieve the same to first order).
#pragma once

#include "solver/engine/bolt/slot_line.h"
#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// The gradients of a bolt's links with respect to the unknowns of blocks are left out where only strains are needed.
enum class RockGradients { Given, LeftOut };

struct BoltStep {
    BoltStep(const Model& wholeModel, const State& wholeState, int boltIndex, StepProblem& stepProblem,
             RockGradients rockGradients = RockGradients::Given);

    /// Current line of one of the bolt's slots. Neighbouring nodes mostly ask for the same one.
    const SlotLine& lineOf(int slot);

    /// Adds a link between a node and block `block` (of a slot or plate), acting along `direction`.
    /// \param strain current strain of the link
    /// \param share as in Law::share
    Link& toRock(LinkKind kind, int node, int block, const Point& direction, double strain, double share);

    /// Adds a link between the two ends of an element; `strain` and `share` are as in `toRock`.
    /// \param g1 gradient of the strain with respect to the displacements and rotation of the element's first node
    /// \param g2 the same for its second node
    Link& ofElement(LinkKind kind, int element, double strain, double share, const Eigen::Vector3d& g1,
                    const Eigen::Vector3d& g2);

    /// Index of the link added last.
    int last() const { return static_cast<int>(problem.links.size()) - 1; }

    const Model& model;
    const State& state;
    const BoltModel& bolt;
    const BoltMotion& motion;
    StepProblem& problem;
    int index;
    int firstBody;  // body of the bolt's node 0 in the step

private:
    const BlockFrame& frameOfBlock(int block);

    RockGradients rockGradients_;
    int lastSlot_ = -1, lastBlock_ = -1;  // those of the two below; −1: none yet
    SlotLine line_;
    BlockFrame frame_;
};

}  // namespace keyblock
