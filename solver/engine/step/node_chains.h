// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolt nodes of a step, condensed onto the blocks. Nodes that are linked one after
// the other form a chain, as those of a bolt do. With the tangents of a trial, the
// nodes of a chain follow from the displacements of the blocks that its links act on,
// and the chain acts on these blocks like one linear spring.
#pragma once

#include "solver/engine/step/trial.h"

#include <vector>

namespace keyblock {

/// Force of a chain on the blocks that it is linked to, six entries per block, with the nodes in equilibrium:
/// `force` − `stiffness`·v, where v are the displacements of these blocks beyond those of the trial.
struct CondensedChain {
    Eigen::MatrixXd stiffness;
    Eigen::VectorXd force;
};

class NodeChains {
public:
    /// Finds the chains. \pre nodes are linked to their neighbours in number only, and to blocks.
    NodeChains(const StepProblem& problem, const LinkRows& rows);

    std::size_t count() const { return chains_.size(); }

    /// Blocks that the links of chain c act on, in ascending order.
    const std::vector<int>& blocks(std::size_t c) const { return chains_[c].blocks; }

    /// Eliminates the nodes of chain c, with the forces and tangents of a trial.
    CondensedChain condensed(std::size_t c, const Trial& trial) const;

private:
    struct Chain {
        int first = 0, end = 0;  // bodies of its nodes
        std::vector<int> blocks;
        std::vector<std::size_t> links;
    };

    const StepProblem& problem_;
    const LinkRows& rows_;
    std::vector<Chain> chains_;
};

}  // namespace keyblock
