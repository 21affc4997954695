// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/supernodal_solve.h"

#include "solver/engine/step/parallel.h"

#include <tbb/task_arena.h>

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

/// Solves with the columns of a supernode. `outside` takes the contributions to the rows from `end` on, which `place`
/// numbers.
void forwardOne(const Supernode& node, std::span<double> x, int end, const int* place, double* outside, double* t) {
    double* own = &x[node.first];
    std::copy_n(own, node.width, t);
    std::fill(t + node.width, t + node.height, 0.0);
    forward(node, t);
    std::copy_n(t, node.width, own);
    int i = node.width;
    for (; i < node.height && node.rows[i] < end; ++i) x[node.rows[i]] += t[i];
    for (; i < node.height; ++i) outside[place[node.rows[i]]] += t[i];
}

void backwardOne(const Supernode& node, std::span<double> x, double* t) {
    for (int i = 0; i < node.height; ++i) t[i] = x[node.rows[i]];
    backward(node, t);
    std::copy_n(t, node.width, &x[node.first]);
}

}  // namespace

void SupernodalSolve::analyse(const cholmod_factor& factor) {
    parts_.clear();
    for (const Subtree& subtree : subtreesForThreads(factor)) parts_.push_back({subtree, {}});
    if (parts_.size() == 1) parts_.clear();
    top_.clear();
    auto part = parts_.begin();
    for (int s = 0; s < static_cast<int>(factor.nsuper); ++s) {
        if (part != parts_.end() && s == part->range.begin) s = part++->range.end - 1;
        else top_.push_back(s);
    }
    workspaces_.assign(1, {});
    workspaces_.front().rows.resize(factor.n);
}

/// Rows outside a subtree to which its supernodes contribute.
std::span<const int> SupernodalSolve::rowsOutside(const cholmod_factor& factor, const Part& part) const {
    const Supernode root = supernode(factor, static_cast<std::size_t>(part.range.end - 1));
    return {root.rows + root.width, root.rows + root.height};
}

void SupernodalSolve::apply(const cholmod_factor& factor, std::span<double> x) {
    assert(factor.is_super);
    forEachPart([&](Part& part, Workspace& work) { forwardIn(factor, part, x, work); });
    for (const Part& part : parts_) {
        const std::span<const int> rows = rowsOutside(factor, part);
        for (std::size_t i = 0; i < rows.size(); ++i) x[rows[i]] += part.outside[i];
    }
    double* t = workspaces_.front().rows.data();
    const auto nodeOf = [&](std::size_t k) { return supernode(factor, static_cast<std::size_t>(top_[k])); };
    for (std::size_t k = 0; k < top_.size(); ++k) {
        if (k + 1 < top_.size()) fetch(nodeOf(k + 1), 0);
        forwardOne(nodeOf(k), x, static_cast<int>(factor.n), nullptr, nullptr, t);
    }
    for (std::size_t k = top_.size(); k-- > 0;) backwardOne(nodeOf(k), x, t);
    forEachPart([&](const Part& part, Workspace& work) { backwardIn(factor, part, x, work); });
}

void SupernodalSolve::forEachPart(const auto& body) {
    if (parts_.empty()) return;
    workspaces_.resize(std::max<std::size_t>(workspaces_.size(), tbb::this_task_arena::max_concurrency()));
    inParallel(parts_.size(), 1, [&](std::size_t i) {
        Workspace& work = workspaces_[tbb::this_task_arena::current_thread_index()];
        work.rows.resize(workspaces_.front().rows.size());
        body(parts_[i], work);
    });
}

void SupernodalSolve::forwardIn(const cholmod_factor& factor, Part& part, std::span<double> x, Workspace& work) const {
    const std::span<const int> rows = rowsOutside(factor, part);
    part.outside.assign(rows.size(), 0.0);
    work.place.resize(factor.n);
    for (std::size_t i = 0; i < rows.size(); ++i) work.place[rows[i]] = static_cast<int>(i);
    const std::size_t begin = part.range.begin, end = part.range.end;
    const Supernode root = supernode(factor, end - 1);
    for (std::size_t s = begin; s < end; ++s) {
        if (s + 1 < end) fetch(supernode(factor, s + 1), 0);
        forwardOne(supernode(factor, s), x, root.first + root.width, work.place.data(), part.outside.data(),
                   work.rows.data());
    }
}

void SupernodalSolve::backwardIn(const cholmod_factor& factor, const Part& part, std::span<double> x,
                                 Workspace& work) const {
    const std::size_t begin = part.range.begin, end = part.range.end;
    for (std::size_t s = end; s-- > begin;) backwardOne(supernode(factor, s), x, work.rows.data());
}

}  // namespace keyblock
