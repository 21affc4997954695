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

/// Operations, as a sum of width · height², from which a factor is divided among threads: those of about 2,000 blocks.
constexpr double worthThreads = 3e8;
/// Share of the operations that a subtree for one thread may have at most and at least.
constexpr double mostOfSubtree = 0.3, leastOfSubtree = 0.005;

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

/// Operations of the supernodes, summed over the subtree below each.
struct TreeWork {
    std::vector<int> parent;  // per supernode; −1: root
    std::vector<int> begin;  // per supernode: first supernode of its subtree
    std::vector<double> work;  // of the subtree
    bool isPostordered = true;  // each subtree is a sequence of supernodes
};

TreeWork treeWork(const cholmod_factor& factor, const std::vector<int>& supernodeOf) {
    const auto count = static_cast<int>(factor.nsuper);
    TreeWork tree{std::vector<int>(factor.nsuper, -1), {}, std::vector<double>(factor.nsuper, 0.0)};
    std::vector<int> size(factor.nsuper, 1);
    for (int s = 0; s < count; ++s) tree.begin.push_back(s);
    for (int s = 0; s < count; ++s) {
        const Supernode node = supernode(factor, static_cast<std::size_t>(s));
        tree.work[s] += static_cast<double>(node.width) * node.height * node.height;
        tree.isPostordered = tree.isPostordered && size[s] == s - tree.begin[s] + 1;
        if (node.height == node.width) continue;
        const int parent = tree.parent[s] = supernodeOf[node.rows[node.width]];
        tree.work[parent] += tree.work[s];
        tree.begin[parent] = std::min(tree.begin[parent], tree.begin[s]);
        size[parent] += size[s];
    }
    return tree;
}

}  // namespace

void SupernodalFactor::analyse(const cholmod_factor& factor) {
    reserveBlasMemory();
    const auto* super = static_cast<const int*>(factor.super);
    supernodeOf_.resize(factor.n);
    for (std::size_t s = 0; s < factor.nsuper; ++s)
        std::fill(supernodeOf_.begin() + super[s], supernodeOf_.begin() + super[s + 1], static_cast<int>(s));
    waiting_.resize(factor.nsuper);
    workspaces_.assign(1, {});
    prepare(workspaces_.front(), factor);
    findSubtrees(factor);
}

void SupernodalFactor::prepare(Workspace& work, const cholmod_factor& factor) const {
    work.place.resize(factor.n);
    work.product.resize(factor.maxcsize);
    work.placeOfRow.resize(factor.n);
}

/// Lists the largest subtrees below a share of the work. What is left above them is done by one thread: for a wall of
/// 20,000 blocks 40 % of the operations.
void SupernodalFactor::findSubtrees(const cholmod_factor& factor) {
    subtrees_.clear();
    const TreeWork tree = treeWork(factor, supernodeOf_);
    double whole = 0.0;
    for (std::size_t s = 0; s < factor.nsuper; ++s)
        if (tree.parent[s] < 0) whole += tree.work[s];
    if (whole < worthThreads || !tree.isPostordered) return;
    for (std::size_t s = 0; s < factor.nsuper; ++s) {
        const bool isPart = tree.work[s] <= mostOfSubtree * whole && tree.work[s] >= leastOfSubtree * whole;
        const bool within = tree.parent[s] >= 0 && tree.work[tree.parent[s]] <= mostOfSubtree * whole;
        if (isPart && !within) subtrees_.push_back({tree.begin[s], static_cast<int>(s) + 1, -1, {}});
    }
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
    Subtree all{0, static_cast<int>(factor.nsuper), -1, {}};
    std::size_t next = 0;
    for (int s = 0; s < all.end; ++s) {
        if (parallel && next < subtrees_.size() && subtrees_[next].begin == s) {
            const Subtree& done = subtrees_[next++];
            if (done.lost >= 0) return done.lost;
            joinLists(done);
            s = done.end - 1;
            continue;
        }
        if (const int lost = factorOne(matrix, factor, s, workspaces_.front(), all); lost >= 0) return lost;
    }
    return -1;
}

void SupernodalFactor::factorSubtree(const cholmod_sparse& matrix, cholmod_factor& factor, Subtree& part,
                                     Workspace& work) {
    part.outside.clear();
    part.lost = -1;
    for (int s = part.begin; s < part.end && part.lost < 0; ++s) part.lost = factorOne(matrix, factor, s, work, part);
}

/// \return the column whose pivot is not positive, or −1.
int SupernodalFactor::factorOne(const cholmod_sparse& matrix, cholmod_factor& factor, int s, Workspace& work,
                                Subtree& part) {
    const Supernode node = supernode(factor, static_cast<std::size_t>(s));
    for (int i = 0; i < node.height; ++i) work.place[node.rows[i]] = i;
    take(matrix, node, work);
    subtractAll(factor, s, node, work, part);
    if (const int lost = factorAlone(node); lost >= 0) return node.first + lost;
    if (node.height > node.width) wait(s, node, node.width, part);
    return -1;
}

/// Puts the lists of a subtree before those of the supernodes that were factored earlier, as if it had been factored now.
void SupernodalFactor::joinLists(const Subtree& part) {
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
                                   Subtree& part) {
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
void SupernodalFactor::wait(int s, const Supernode& node, int done, Subtree& part) {
    const int target = supernodeOf_[node.rows[done]];
    int* first = &first_[target];
    if (target >= part.end) {
        auto list = std::find_if(part.outside.begin(), part.outside.end(),
                                 [&](const auto& l) { return l.first == target; });
        if (list == part.outside.end()) list = part.outside.insert(list, {target, -1});
        first = &list->second;
    }
    waiting_[s] = {*first, done};
    *first = s;
}

}  // namespace keyblock
