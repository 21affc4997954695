// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The supernodal Cholesky factor of a matrix, by columns from the left (Ng and Peyton
// 1993): a supernode takes what all supernodes that reach it subtract from its columns,
// and is then factored by itself. The products are those of CHOLMOD's own factorization,
// in its order, with the same digits; that one begins several parallel regions of OpenMP
// for every supernode, which cost more than the loops in them where there is one thread.
#pragma once

#include "solver/engine/step/supernode.h"

#include <vector>

namespace keyblock {

class SupernodalFactor {
public:
    /// Takes the pattern of a factor, which every later call has to have.
    void analyse(const cholmod_factor& factor);

    /// Makes the factor of a matrix, the lower triangle of which has columns and rows in the order of elimination.
    /// \return −1; or the first column whose pivot is not positive: the factor is then of no use.
    /// \pre the factor has room for its values.
    int apply(const cholmod_sparse& matrix, cholmod_factor& factor);

private:
    /// A supernode that has been factored, among those that have to be subtracted from the same one next.
    struct Waiting {
        int next = -1;  // of the list; −1: the last
        int done = 0;  // rows of its that have been subtracted
    };

    void take(const cholmod_sparse& matrix, const Supernode& node);
    void subtractAll(const cholmod_factor& factor, std::size_t s, const Supernode& node);
    int subtract(const Supernode& from, int done, const Supernode& node);
    void wait(std::size_t s, const Supernode& node, int done);

    std::vector<int> supernodeOf_;  // per row
    std::vector<int> place_;  // per row: its place among the rows of the supernode at hand
    std::vector<int> first_;  // per supernode: head of the list of those that wait for it; −1: none
    std::vector<Waiting> waiting_;  // per supernode
    std::vector<double> product_;  // work space of `subtract`
    std::vector<int> placeOfRow_;
};

}  // namespace keyblock
