// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/supernodal_solve.h"

#include <cblas.h>

#include <algorithm>

namespace keyblock {
namespace {

constexpr int panel = 12;  // columns at a time: two blocks

/// One supernode: `width` columns of `height` entries, the first `width` of them on the diagonal.
struct Supernode {
    const double* values = nullptr;
    const int* rows = nullptr;
    int width = 0, height = 0;

    const double* at(int row, int column) const { return values + row + static_cast<std::ptrdiff_t>(column) * height; }
};

Supernode supernode(const cholmod_factor& factor, std::size_t s) {
    const auto *super = static_cast<const int*>(factor.super), *rowStart = static_cast<const int*>(factor.pi);
    const auto* valueStart = static_cast<const int*>(factor.px);
    return {static_cast<const double*>(factor.x) + valueStart[s], static_cast<const int*>(factor.s) + rowStart[s],
            super[s + 1] - super[s], rowStart[s + 1] - rowStart[s]};
}

/// \param t the rows of the supernode; those below the diagonal collect what its columns take from them.
void forward(const Supernode& node, double* t) {
    for (int begin = 0; begin < node.width; begin += panel) {
        const int end = std::min(begin + panel, node.width);
        for (int j = begin; j < end; ++j) {
            const double *column = node.at(0, j), x = t[j] /= column[j];
            for (int i = j + 1; i < end; ++i) t[i] -= column[i] * x;
        }
        if (end < node.height)
            cblas_dgemv(CblasColMajor, CblasNoTrans, node.height - end, end - begin, -1.0, node.at(end, begin), node.height,
                        t + begin, 1, 1.0, t + end, 1);
    }
}

void backward(const Supernode& node, double* t) {
    for (int begin = (node.width - 1) / panel * panel; begin >= 0; begin -= panel) {
        const int end = std::min(begin + panel, node.width);
        if (end < node.height)
            cblas_dgemv(CblasColMajor, CblasTrans, node.height - end, end - begin, -1.0, node.at(end, begin), node.height,
                        t + end, 1, 1.0, t + begin, 1);
        for (int j = end - 1; j >= begin; --j) {
            const double* column = node.at(0, j);
            for (int i = j + 1; i < end; ++i) t[j] -= column[i] * t[i];
            t[j] /= column[j];
        }
    }
}

}  // namespace

void solveSupernodes(const cholmod_factor& factor, std::span<double> x, std::vector<double>& work) {
    work.resize(factor.n);
    double* t = work.data();
    for (std::size_t s = 0; s < factor.nsuper; ++s) {
        const Supernode node = supernode(factor, s);
        double* own = &x[static_cast<std::size_t>(node.rows[0])];
        std::copy_n(own, node.width, t);
        std::fill(t + node.width, t + node.height, 0.0);
        forward(node, t);
        std::copy_n(t, node.width, own);
        for (int i = node.width; i < node.height; ++i) x[static_cast<std::size_t>(node.rows[i])] += t[i];
    }
    for (std::size_t s = factor.nsuper; s-- > 0;) {
        const Supernode node = supernode(factor, s);
        for (int i = 0; i < node.height; ++i) t[i] = x[static_cast<std::size_t>(node.rows[i])];
        backward(node, t);
        std::copy_n(t, node.width, &x[static_cast<std::size_t>(node.rows[0])]);
    }
}

}  // namespace keyblock
