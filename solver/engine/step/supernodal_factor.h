// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Left-looking supernodal Cholesky factorisation (Ng and Peyton 1993): the updates from
// all earlier supernodes that reach a supernode are subtracted from its columns, which
// are then factored on their own. The products are those of CHOLMOD's own factorisation,
// in the same order and with identical results. CHOLMOD starts several OpenMP parallel
// regions per supernode, which on a single thread cost more than the loops in them.
//
// In a large factor, subtrees of the elimination tree are factored in parallel. Within
// one the work is the same as without threads. Its updates of later supernodes are
// collected and take their place in the lists when the sequence reaches them, so that
// every sum has the same order and the same bits on any number of threads.
#pragma once

#include "solver/engine/step/elimination_tree.h"
#include "solver/engine/step/supernode.h"

#include <utility>
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

    /// Arrays that a thread uses while it factors a supernode.
    struct Workspace {
        std::vector<int> place;  // per row: its index among the rows of the current supernode
        std::vector<double> product;  // of `subtract`
        std::vector<int> placeOfRow;
    };

    /// Supernodes that are factored in turn. Of their updates of later ones it keeps the heads of the lists.
    struct Part {
        Subtree range;
        int lost = -1;  // first column whose pivot is not positive; −1: none
        std::vector<std::pair<int, int>> outside;  // supernode beyond the end, and the head of the list for it
    };

    bool mayUseThreads() const;
    void prepare(Workspace& work, const cholmod_factor& factor) const;
    int factorOne(const cholmod_sparse& matrix, cholmod_factor& factor, int s, Workspace& work, Part& part);
    void factorSubtree(const cholmod_sparse& matrix, cholmod_factor& factor, Part& part, Workspace& work);
    void joinLists(const Part& part);
    void take(const cholmod_sparse& matrix, const Supernode& node, const Workspace& work) const;
    void subtractAll(const cholmod_factor& factor, int s, const Supernode& node, Workspace& work, Part& part);
    int subtract(const Supernode& from, int done, const Supernode& node, Workspace& work) const;
    void wait(int s, const Supernode& node, int done, Part& part);

    std::vector<int> supernodeOf_;  // per row
    std::vector<int> first_;  // per supernode: head of the list of supernodes waiting to update it; −1: none
    std::vector<Waiting> waiting_;  // per supernode
    std::vector<Part> subtrees_;  // those that are worth a thread, in order
    std::vector<Workspace> workspaces_;  // per thread
};

}  // namespace keyblock
