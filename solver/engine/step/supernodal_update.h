// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ranks added to a supernodal Cholesky factor, or taken from it, where it lies. A
// factor in supernodes is solved with in less than half the time of one in single
// columns, and several ranks at once are a few products of small dense matrices a
// supernode. CHOLMOD's own updates need single columns.
#pragma once

#include "solver/engine/step/sparse_column.h"
#include "solver/engine/step/supernode.h"

#include <cstdint>
#include <span>

namespace keyblock {

class SupernodalUpdate {
public:
    /// Takes the pattern of a factor, which every later call has to have.
    void analyse(const cholmod_factor& factor);

    /// Makes the factor L·Lᵀ of A that of A + Σ c·cᵀ, or of A − Σ c·cᵀ.
    /// \param columns rows in the order of elimination.
    /// \return false when the result is not positive definite: the factor is then of no use.
    /// \pre the pattern of the factor holds every product of two entries of one column.
    bool apply(cholmod_factor& factor, bool add, std::span<const SparseColumn> columns);

private:
    /// Some columns of a supernode, from the first row on its diagonal.
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
    std::vector<double> columns_;  // what is left of the ranks of a group, side by side in every row; zero between calls
    std::vector<std::uint32_t> ranksAt_;  // per supernode: a bit for every rank that reaches it
    std::vector<double> gathered_;  // of one supernode or panel: a column per rank
    std::vector<double> scaled_, left_, diagonal_, mixed_, work_;  // work space of `updatePanel`
};

}  // namespace keyblock
