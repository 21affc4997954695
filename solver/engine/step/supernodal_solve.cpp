// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/supernodal_solve.h"

#include "solver/engine/step/supernode.h"

#include <cblas.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace keyblock {
namespace {

constexpr int panelColumns = 12;  // columns per panel: two blocks

/// Solves with a lower triangle of `count` columns, whose first entry is at `corner`, from the first row to the last.
/// The unknowns are in a copy that the compiler keeps in registers.
template <int count>
void solveDown(const double* corner, int stride, double* t) {
    std::array<double, count> x;
    std::copy_n(t, count, x.begin());
#pragma GCC unroll 12
    for (int j = 0; j < count; ++j) {
        const double *column = corner + static_cast<std::ptrdiff_t>(j) * stride, solved = x[j] /= column[j];
#pragma GCC unroll 12
        for (int i = j + 1; i < count; ++i) x[i] -= column[i] * solved;
    }
    std::copy_n(x.begin(), count, t);
}

/// Solves with the transposed triangle, from the last row to the first.
template <int count>
void solveUp(const double* corner, int stride, double* t) {
    std::array<double, count> x;
    std::copy_n(t, count, x.begin());
#pragma GCC unroll 12
    for (int j = count - 1; j >= 0; --j) {
        const double* column = corner + static_cast<std::ptrdiff_t>(j) * stride;
#pragma GCC unroll 12
        for (int i = j + 1; i < count; ++i) x[j] -= column[i] * x[i];
        x[j] /= column[j];
    }
    std::copy_n(x.begin(), count, t);
}

using Solve = void (*)(const double* corner, int stride, double* t);

/// Functions by number of columns. Loops of known length are unrolled, because processors predict the end of short
/// loops poorly.
template <std::size_t... counts>
constexpr std::array<Solve, panelColumns + 1> downBy(std::index_sequence<counts...>) {
    return {solveDown<static_cast<int>(counts)>...};
}

template <std::size_t... counts>
constexpr std::array<Solve, panelColumns + 1> upBy(std::index_sequence<counts...>) {
    return {solveUp<static_cast<int>(counts)>...};
}

constexpr auto down = downBy(std::make_index_sequence<panelColumns + 1>());
constexpr auto up = upBy(std::make_index_sequence<panelColumns + 1>());

/// Prefetches the next triangle, whose columns are too far apart for the processor to fetch them in time by itself.
void fetch(const Supernode& node, int begin) {
    const int end = std::min(begin + panelColumns, node.width);
    for (int j = begin; j < end; ++j) __builtin_prefetch(node.at(j, j));
}

/// \param t the rows of the supernode; those below the diagonal accumulate the contributions of its columns.
void forward(const Supernode& node, double* t) {
    for (int begin = 0; begin < node.width; begin += panelColumns) {
        const int end = std::min(begin + panelColumns, node.width);
        down[end - begin](node.at(begin, begin), node.height, t + begin);
        if (end < node.width) fetch(node, end);
        if (end < node.height)
            cblas_dgemv(CblasColMajor, CblasNoTrans, node.height - end, end - begin, -1.0, node.at(end, begin), node.height,
                        t + begin, 1, 1.0, t + end, 1);
    }
}

void backward(const Supernode& node, double* t) {
    for (int begin = (node.width - 1) / panelColumns * panelColumns; begin >= 0; begin -= panelColumns) {
        const int end = std::min(begin + panelColumns, node.width);
        fetch(node, begin);
        if (end < node.height)
            cblas_dgemv(CblasColMajor, CblasTrans, node.height - end, end - begin, -1.0, node.at(end, begin), node.height,
                        t + end, 1, 1.0, t + begin, 1);
        up[end - begin](node.at(begin, begin), node.height, t + begin);
    }
}

}  // namespace

void solveSupernodes(const cholmod_factor& factor, std::span<double> x, std::vector<double>& work) {
    assert(factor.is_super);
    work.resize(factor.n);
    double* t = work.data();
    for (std::size_t s = 0; s < factor.nsuper; ++s) {
        const Supernode node = supernode(factor, s);
        double* own = &x[node.rows[0]];
        std::copy_n(own, node.width, t);
        std::fill(t + node.width, t + node.height, 0.0);
        if (s + 1 < factor.nsuper) fetch(supernode(factor, s + 1), 0);
        forward(node, t);
        std::copy_n(t, node.width, own);
        for (int i = node.width; i < node.height; ++i) x[node.rows[i]] += t[i];
    }
    for (std::size_t s = factor.nsuper; s-- > 0;) {
        const Supernode node = supernode(factor, s);
        for (int i = 0; i < node.height; ++i) t[i] = x[node.rows[i]];
        backward(node, t);
        std::copy_n(t, node.width, &x[node.rows[0]]);
    }
}

}  // namespace keyblock
