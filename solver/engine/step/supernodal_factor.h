// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Left-looking supernodal Cholesky factorisation (Ng and Peyton 1993): the updates from
// all earlier supernodes that reach a supernode are subtracted from its columns, which
// are then factored on their own. The products are those of CHOLMOD's own factorisation,
// in the same order and with identical results. CHOLMOD starts several OpenMP parallel
// regions per supernode, which on a single thread cost more than the loops in them.
#pragma once

#include "solver/engine/step/supernode.h"

#include <vector>

namespace keyblock {

class SupernodalFactor {
public:
    /// Stores the pattern of a factor. All later calls must use a factor with this pattern.
    void analyse(const cholmod_factor& factor);

    /// Computes the factor of a matrix.
    /// \param matrix the lower triangle, with rows and columns in elimination order.
    /// \return −1 on success. If a pivot is not positive, the index of the first such column; `factor` is then invalid.
    /// \pre the values of `factor` have been allocated.
    int apply(const cholmod_sparse& matrix, cholmod_factor& factor);

private:
    /// Entry in a linked list of the factored supernodes that are to update the same supernode next.
    struct Waiting {
        int next = -1;  // next supernode of the list; −1: last
        int done = 0;  // number of rows already used in updates
    };

    void take(const cholmod_sparse& matrix, const Supernode& node);
    void subtractAll(const cholmod_factor& factor, std::size_t s, const Supernode& node);
    int subtract(const Supernode& from, int done, const Supernode& node);
    void wait(std::size_t s, const Supernode& node, int done);

    std::vector<int> supernodeOf_;  // per row
    std::vector<int> place_;  // per row: its index among the rows of the current supernode
    std::vector<int> first_;  // per supernode: head of the list of supernodes waiting to update it; −1: none
    std::vector<Waiting> waiting_;  // per supernode
    std::vector<double> product_;  // workspace of `subtract`
    std::vector<int> placeOfRow_;
};

}  // namespace keyblock
