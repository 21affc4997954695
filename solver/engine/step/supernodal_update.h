// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In-place updates and downdates of a supernodal Cholesky factor by several ranks. A
// solution with a supernodal factor takes less than half the time of one with a
// simplicial factor, and an update by several ranks at once takes a few products of
// small dense matrices per supernode. CHOLMOD's own updates need a simplicial factor.
#pragma once

#include "solver/engine/step/sparse_column.h"
#include "solver/engine/step/supernode.h"

#include <cstdint>
#include <span>

namespace keyblock {

class SupernodalUpdate {
public:
    /// Stores the pattern of a factor. All later calls must use a factor with this pattern.
    void analyse(const cholmod_factor& factor);

    /// Turns the factor L·Lᵀ of A into the factor of A + Σ c·cᵀ (if `add` is true) or A − Σ c·cᵀ (if false).
    /// \param columns the vectors c, with rows in elimination order.
    /// \return false if the result is not positive definite; the factor is then invalid.
    /// \pre for every c in `columns`, the pattern of the factor contains all non-zero entries of the lower triangle of
    /// c·cᵀ.
    bool apply(cholmod_factor& factor, bool add, std::span<const SparseColumn> columns);

private:
    /// Consecutive columns of a supernode, from the row of the first column's diagonal entry downwards.
    struct Panel {
        double* values = nullptr;
        int stride = 0, width = 0, height = 0;
    };

    bool applyGroup(cholmod_factor& factor, double sign, std::span<const SparseColumn* const> columns);
    void gather(const Supernode& node, std::uint32_t ranks);
    void scatter(const Supernode& node, std::uint32_t ranks);
    bool update(const Supernode& node, double sign, int ranks);
    bool updatePanel(const Panel& panel, double sign, int ranks);
    void updateBelow(const Panel& panel, double sign, int ranks);
    bool timesDiagonal(const Panel& panel) const;

    std::vector<int> supernodeOf_;  // per row
    std::vector<double> columns_;  // remainders of a group's vectors, interleaved by row; zero between calls
    std::vector<std::uint32_t> ranksAt_;  // per supernode: one bit for each rank that reaches it
    std::vector<double> gathered_;  // rows of one supernode or panel, one column per rank
    std::vector<double> scaled_, left_, diagonal_, mixed_, work_;  // workspace of `updatePanel`
};

}  // namespace keyblock
