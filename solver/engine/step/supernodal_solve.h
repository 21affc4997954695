// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solution with a supernodal Cholesky factor for one right-hand side. A few columns at
// a time are solved with a small triangle in plain loops and then multiplied into all
// rows below at once. The triangular solver of the BLAS processes one column after the
// other, each with a separate call.
//
// In a large factor, threads share the subtrees of the elimination tree. What a subtree
// contributes to rows outside it is added up apart and then in the order of the
// subtrees, also by a single thread, so that the bits do not depend on their number.
#pragma once

#include "solver/engine/step/elimination_tree.h"
#include "solver/engine/step/supernode.h"

#include <span>
#include <vector>

namespace keyblock {

class SupernodalSolve {
public:
    /// Stores the pattern of a factor. All later calls must use a factor with this pattern.
    /// \pre the factor is supernodal.
    void analyse(const cholmod_factor& factor);

    /// Replaces x (n values in elimination order) by (L·Lᵀ)⁻¹·x.
    void apply(const cholmod_factor& factor, std::span<double> x);

private:
    /// Arrays that a thread uses.
    struct Workspace {
        std::vector<double> rows;  // of one supernode
        std::vector<int> place;  // per row outside a subtree: its index in `Part::outside`
    };
    /// A subtree, and the sums of its contributions to the rows outside it.
    struct Part {
        Subtree range;
        std::vector<double> outside;
    };

    std::span<const int> rowsOutside(const cholmod_factor& factor, const Part& part) const;
    void forwardIn(const cholmod_factor& factor, Part& part, std::span<double> x, Workspace& work) const;
    void backwardIn(const cholmod_factor& factor, const Part& part, std::span<double> x, Workspace& work) const;
    void forEachPart(const auto& body);

    std::vector<Part> parts_;
    std::vector<int> top_;  // the supernodes outside the subtrees, in order
    std::vector<Workspace> workspaces_;  // per thread
};

}  // namespace keyblock
