// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/supernodal_solve.h"

#include "solver/engine/step/supernode.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
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

/// Two numbers on which the processor calculates at once.
using Two [[gnu::vector_size(16)]] = double;

Two twoAt(const double* from) {
    Two two;
    std::memcpy(&two, from, sizeof two);
    return two;
}

/// Subtracts from `rows` unknowns the product of `count` columns, whose first entry is at `first`, and the solved
/// unknowns `x`. For so few columns, a call of BLAS takes longer than the product.
template <int count>
void subtractProduct(const double* first, int stride, int rows, const double* x, double* t) {
    std::array<double, count> solved;
    std::copy_n(x, count, solved.begin());
    const auto column = [&](int j) { return first + static_cast<std::ptrdiff_t>(j) * stride; };
    int i = 0;
    for (; i + 4 <= rows; i += 4) {
        Two low = twoAt(t + i), high = twoAt(t + i + 2);
#pragma GCC unroll 12
        for (int j = 0; j < count; ++j) {
            low -= twoAt(column(j) + i) * solved[j];
            high -= twoAt(column(j) + i + 2) * solved[j];
        }
        std::memcpy(t + i, &low, sizeof low);
        std::memcpy(t + i + 2, &high, sizeof high);
    }
    for (; i < rows; ++i)
        for (int j = 0; j < count; ++j) t[i] -= column(j)[i] * solved[j];
}

/// Subtracts from the unknowns `x` the product of the transposed columns and `rows` solved unknowns.
template <int count>
void subtractTransposed(const double* first, int stride, int rows, const double* solved, double* x) {
    std::array<Two, count> sums{};
    const auto column = [&](int j) { return first + static_cast<std::ptrdiff_t>(j) * stride; };
    int i = 0;
    for (; i + 2 <= rows; i += 2) {
        const Two two = twoAt(solved + i);
#pragma GCC unroll 12
        for (int j = 0; j < count; ++j) sums[j] += twoAt(column(j) + i) * two;
    }
    for (int j = 0; j < count; ++j) {
        double sum = sums[j][0] + sums[j][1];
        if (i < rows) sum += column(j)[i] * solved[i];
        x[j] -= sum;
    }
}

/// The functions for a number of columns. Loops of known length are unrolled, because processors predict the end of
/// short loops poorly.
struct Panel {
    void (*solveDown)(const double* corner, int stride, double* t);
    void (*solveUp)(const double* corner, int stride, double* t);
    void (*subtractProduct)(const double* first, int stride, int rows, const double* x, double* t);
    void (*subtractTransposed)(const double* first, int stride, int rows, const double* solved, double* x);
};

template <int count>
constexpr Panel panelOf() {
    return {solveDown<count>, solveUp<count>, subtractProduct<count>, subtractTransposed<count>};
}

template <std::size_t... counts>
constexpr std::array<Panel, panelColumns + 1> panelsBy(std::index_sequence<counts...>) {
    return {panelOf<static_cast<int>(counts)>()...};
}

constexpr auto panels = panelsBy(std::make_index_sequence<panelColumns + 1>());

/// Prefetches the next triangle, whose columns are too far apart for the processor to fetch them in time by itself.
void fetch(const Supernode& node, int begin) {
    const int end = std::min(begin + panelColumns, node.width);
    for (int j = begin; j < end; ++j) __builtin_prefetch(node.at(j, j));
}

/// \param t the rows of the supernode; those below the diagonal accumulate the contributions of its columns.
void forward(const Supernode& node, double* t) {
    for (int begin = 0; begin < node.width; begin += panelColumns) {
        const int end = std::min(begin + panelColumns, node.width);
        const Panel& panel = panels[end - begin];
        panel.solveDown(node.at(begin, begin), node.height, t + begin);
        if (end < node.width) fetch(node, end);
        if (end < node.height)
            panel.subtractProduct(node.at(end, begin), node.height, node.height - end, t + begin, t + end);
    }
}

void backward(const Supernode& node, double* t) {
    for (int begin = (node.width - 1) / panelColumns * panelColumns; begin >= 0; begin -= panelColumns) {
        const int end = std::min(begin + panelColumns, node.width);
        const Panel& panel = panels[end - begin];
        fetch(node, begin);
        if (end < node.height)
            panel.subtractTransposed(node.at(end, begin), node.height, node.height - end, t + end, t + begin);
        panel.solveUp(node.at(begin, begin), node.height, t + begin);
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
