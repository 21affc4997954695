// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subtrees of the elimination tree of a large factor, which do not depend on each other
// and are divided among threads.
#pragma once

#include <cholmod.h>

#include <vector>

namespace keyblock {

/// Successive supernodes that form a subtree. Rows beyond it to which they contribute are rows of the last one.
struct Subtree {
    int begin = 0, end = 0;
};

/// The supernode of each row of a supernodal factor.
std::vector<int> supernodeOfRows(const cholmod_factor& factor);

/// The largest subtrees below a share of the operations, in order. Empty for factors of fewer than some 2,000 blocks,
/// which are not worth a thread. It depends on the pattern of the factor alone, not on the number of threads.
std::vector<Subtree> subtreesForThreads(const cholmod_factor& factor);

}  // namespace keyblock
