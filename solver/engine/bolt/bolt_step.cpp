// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/bolt_step.h"

namespace keyblock {
namespace {

Link& addLink(BoltStep& step, LinkKind kind, int part, double strain, double share) {
    Link& link = step.problem.links.emplace_back();
    link.kind = kind;
    link.owner = step.index;
    link.part = part;
    link.strain = strain;
    link.law.share = share;
    return link;
}

}  // namespace

BoltStep::BoltStep(const Model& wholeModel, const State& wholeState, int boltIndex, StepProblem& stepProblem,
                   RockGradients rockGradients)
    : model(wholeModel), state(wholeState), bolt(wholeModel.bolts[boltIndex]), motion(wholeState.bolts[boltIndex]),
      problem(stepProblem), index(boltIndex), firstBody(stepProblem.blocks + bolt.firstNode),
      rockGradients_(rockGradients) {}

const SlotLine& BoltStep::lineOf(int slot) {
    if (slot != lastSlot_) line_ = slotLine(state, motion.slots[slot]);
    lastSlot_ = slot;
    return line_;
}

const BlockFrame& BoltStep::frameOfBlock(int block) {
    if (block != lastBlock_) frame_ = frameOf(state.blocks[block]);
    lastBlock_ = block;
    return frame_;
}

Link& BoltStep::toRock(LinkKind kind, int node, int block, const Point& direction, double strain, double share) {
    Link& link = addLink(*this, kind, node, strain, share);
    link.a = firstBody + node;
    link.b = block;
    link.ga.head<2>() = direction;
    if (rockGradients_ == RockGradients::Given)
        link.gb = -displacementMatrix(frameOfBlock(block), motion.nodes[node].x).transpose() * direction;
    return link;
}

Link& BoltStep::ofElement(LinkKind kind, int element, double strain, double share, const Eigen::Vector3d& g1,
                          const Eigen::Vector3d& g2) {
    Link& link = addLink(*this, kind, element, strain, share);
    link.a = firstBody + element + 1;
    link.b = firstBody + element;
    link.ga.head<3>() = g2;
    link.gb.head<3>() = g1;
    return link;
}

}  // namespace keyblock
