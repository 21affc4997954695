// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/supernodal_factor.h"

#include "solver/engine/step/blas_memory.h"
#include "solver/engine/step/parallel.h"

#include <cblas.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>

extern "C" void dpotrf_(const char* triangle, const int* n, double* a, const int* stride, int* info);

namespace keyblock {
namespace {

/// Factors the columns of a supernode on their own.
/// \return the column of the supernode whose pivot is not positive, or −1.
int factorAlone(const Supernode& node) {
    int info = 0;
    dpotrf_("L", &node.width, node.values, &node.height, &info);
    if (info != 0) return info - 1;
    if (node.height > node.width)
        cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, node.height - node.width, node.width, 1.0,
                    node.values, node.height, node.at(node.width, 0), node.height);
    return -1;
}

}  // namespace

void SupernodalFactor::analyse(const cholmod_factor& factor) {
    reserveBlasMemory();
    supernodeOf_ = supernodeOfRows(factor);
    waiting_.resize(factor.nsuper);
    workspaces_.assign(1, {});
    prepare(workspaces_.front(), factor);
    subtrees_.clear();
    for (const Subtree& subtree : subtreesForThreads(factor)) subtrees_.push_back({subtree, -1, {}});
}

void SupernodalFactor::prepare(Workspace& work, const cholmod_factor& factor) const {
    work.place.resize(factor.n);
    work.product.resize(factor.maxcsize);
    work.placeOfRow.resize(factor.n);
}

/// Each thread that factors needs a buffer of OpenBLAS, which would wait for it without end.
bool SupernodalFactor::mayUseThreads() const {
    const auto threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const std::size_t most = std::min<std::size_t>(threads, tbb::this_task_arena::max_concurrency());
    return subtrees_.size() > 1 && most > 1 && hasBlasMemory(most);
}

int SupernodalFactor::apply(const cholmod_sparse& matrix, cholmod_factor& factor) {
    assert(factor.x);
    first_.assign(factor.nsuper, -1);
    const bool parallel = mayUseThreads();
    if (parallel) {
        workspaces_.resize(std::max<std::size_t>(workspaces_.size(), tbb::this_task_arena::max_concurrency()));
        inParallel(subtrees_.size(), 1, [&](std::size_t i) {
            Workspace& work = workspaces_[tbb::this_task_arena::current_thread_index()];
            if (work.place.empty()) prepare(work, factor);
            factorSubtree(matrix, factor, subtrees_[i], work);
        });
    }
    Part all{{0, static_cast<int>(factor.nsuper)}, -1, {}};
    std::size_t next = 0;
    for (int s = 0; s < all.range.end; ++s) {
        if (parallel && next < subtrees_.size() && subtrees_[next].range.begin == s) {
            const Part& done = subtrees_[next++];
            if (done.lost >= 0) return done.lost;
            joinLists(done);
            s = done.range.end - 1;
            continue;
        }
        if (const int lost = factorOne(matrix, factor, s, workspaces_.front(), all); lost >= 0) return lost;
    }
    return -1;
}

void SupernodalFactor::factorSubtree(const cholmod_sparse& matrix, cholmod_factor& factor, Part& part,
                                     Workspace& work) {
    part.outside.clear();
    part.lost = -1;
    for (int s = part.range.begin; s < part.range.end && part.lost < 0; ++s)
        part.lost = factorOne(matrix, factor, s, work, part);
}

/// \return the column whose pivot is not positive, or −1.
int SupernodalFactor::factorOne(const cholmod_sparse& matrix, cholmod_factor& factor, int s, Workspace& work,
                                Part& part) {
    const Supernode node = supernode(factor, static_cast<std::size_t>(s));
    for (int i = 0; i < node.height; ++i) work.place[node.rows[i]] = i;
    take(matrix, node, work);
    subtractAll(factor, s, node, work, part);
    if (const int lost = factorAlone(node); lost >= 0) return node.first + lost;
    if (node.height > node.width) wait(s, node, node.width, part);
    return -1;
}

/// Puts the lists of a subtree before those of the supernodes that were factored earlier, as if it had been factored now.
void SupernodalFactor::joinLists(const Part& part) {
    for (const auto& [target, head] : part.outside) {
        int last = head;
        while (waiting_[last].next >= 0) last = waiting_[last].next;
        waiting_[last].next = first_[target];
        first_[target] = head;
    }
}

/// Copies the columns of the matrix to the rows that they have in the factor.
void SupernodalFactor::take(const cholmod_sparse& matrix, const Supernode& node, const Workspace& work) const {
    const auto *start = static_cast<const int*>(matrix.p), *rows = static_cast<const int*>(matrix.i);
    const auto* entries = static_cast<const double*>(matrix.x);
    std::fill(node.values, node.at(0, node.width), 0.0);
    for (int j = 0; j < node.width; ++j) {
        double* column = node.at(0, j);
        for (int k = start[node.first + j]; k < start[node.first + j + 1]; ++k)
            column[work.place[rows[k]]] = entries[k];
    }
}

/// Subtracts the updates of all waiting supernodes. The one that was added to the list last is subtracted first.
void SupernodalFactor::subtractAll(const cholmod_factor& factor, int s, const Supernode& node, Workspace& work,
                                   Part& part) {
    for (int d = first_[s]; d >= 0;) {
        const Supernode from = supernode(factor, static_cast<std::size_t>(d));
        const int done = subtract(from, waiting_[d].done, node, work);
        const int next = waiting_[d].next;
        if (done < from.height) wait(d, from, done, part);
        d = next;
    }
}

/// Subtracts the update by `from` from the columns of `node`.
/// \return the number of rows of `from` that have then been used.
int SupernodalFactor::subtract(const Supernode& from, int done, const Supernode& node, Workspace& work) const {
    int end = done;
    while (end < from.height && from.rows[end] < node.first + node.width) ++end;
    const int columns = end - done, rows = from.height - done;
    double* product = work.product.data();
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, columns, from.width, 1.0, from.at(done, 0), from.height, 0.0, product,
                rows);
    if (rows > columns)
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, rows - columns, columns, from.width, 1.0, from.at(end, 0), from.height,
                    from.at(done, 0), from.height, 0.0, product + columns, rows);
    int* placeOfRow = work.placeOfRow.data();
    for (int i = 0; i < rows; ++i) placeOfRow[i] = work.place[from.rows[done + i]];
    for (int j = 0; j < columns; ++j, product += rows) {
        double* column = node.at(0, placeOfRow[j]);
        for (int i = j; i < rows; ++i) column[placeOfRow[i]] -= product[i];
    }
    return end;
}

/// Puts a supernode at the head of the list for the supernode that contains its first unused row.
void SupernodalFactor::wait(int s, const Supernode& node, int done, Part& part) {
    const int target = supernodeOf_[node.rows[done]];
    int* first = &first_[target];
    if (target >= part.range.end) {
        auto list = std::find_if(part.outside.begin(), part.outside.end(),
                                 [&](const auto& l) { return l.first == target; });
        if (list == part.outside.end()) list = part.outside.insert(list, {target, -1});
        first = &list->second;
    }
    waiting_[s] = {*first, done};
    *first = s;
}

}  // namespace keyblock
