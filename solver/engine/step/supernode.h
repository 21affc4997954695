// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One supernode of a Cholesky factor: columns with the same row pattern, stored as a
// dense column-major matrix.
#pragma once

#include <cholmod.h>

#include <cstddef>

namespace keyblock {

/// Supernode of `width` columns, starting at column `first` of the factor, with `height` rows. The first `width` rows
/// form the diagonal block.
struct Supernode {
    double* values = nullptr;
    const int* rows = nullptr;  // row indices in elimination order
    int first = 0, width = 0, height = 0;

    double* at(int row, int column) const { return values + row + static_cast<std::ptrdiff_t>(column) * height; }
};

inline Supernode supernode(const cholmod_factor& factor, std::size_t s) {
    const auto *super = static_cast<const int*>(factor.super), *rowStart = static_cast<const int*>(factor.pi);
    const auto* valueStart = static_cast<const int*>(factor.px);
    return {static_cast<double*>(factor.x) + valueStart[s], static_cast<const int*>(factor.s) + rowStart[s], super[s],
            super[s + 1] - super[s], rowStart[s + 1] - rowStart[s]};
}

}  // namespace keyblock
