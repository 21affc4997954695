// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/supernodal_factor.h"

#include "solver/engine/step/blas_memory.h"

#include <cblas.h>

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
    const auto* super = static_cast<const int*>(factor.super);
    supernodeOf_.resize(factor.n);
    for (std::size_t s = 0; s < factor.nsuper; ++s)
        std::fill(supernodeOf_.begin() + super[s], supernodeOf_.begin() + super[s + 1], static_cast<int>(s));
    place_.resize(factor.n);
    waiting_.resize(factor.nsuper);
    product_.resize(factor.maxcsize);
    placeOfRow_.resize(factor.n);
}

int SupernodalFactor::apply(const cholmod_sparse& matrix, cholmod_factor& factor) {
    assert(factor.x);
    first_.assign(factor.nsuper, -1);
    for (std::size_t s = 0; s < factor.nsuper; ++s) {
        const Supernode node = supernode(factor, s);
        for (int i = 0; i < node.height; ++i) place_[node.rows[i]] = i;
        take(matrix, node);
        subtractAll(factor, s, node);
        if (const int lost = factorAlone(node); lost >= 0) return node.first + lost;
        if (node.height > node.width) wait(s, node, node.width);
    }
    return -1;
}

/// Copies the columns of the matrix to the rows that they have in the factor.
void SupernodalFactor::take(const cholmod_sparse& matrix, const Supernode& node) {
    const auto *start = static_cast<const int*>(matrix.p), *rows = static_cast<const int*>(matrix.i);
    const auto* entries = static_cast<const double*>(matrix.x);
    std::fill(node.values, node.at(0, node.width), 0.0);
    for (int j = 0; j < node.width; ++j) {
        double* column = node.at(0, j);
        for (int k = start[node.first + j]; k < start[node.first + j + 1]; ++k)
            column[place_[rows[k]]] = entries[k];
    }
}

/// Subtracts the updates of all waiting supernodes. The one that was added to the list last is subtracted first.
void SupernodalFactor::subtractAll(const cholmod_factor& factor, std::size_t s, const Supernode& node) {
    for (int d = first_[s]; d >= 0;) {
        const std::size_t at = d;
        const Supernode from = supernode(factor, at);
        const int done = subtract(from, waiting_[at].done, node);
        d = waiting_[at].next;
        if (done < from.height) wait(at, from, done);
    }
}

/// Subtracts the update by `from` from the columns of `node`.
/// \return the number of rows of `from` that have then been used.
int SupernodalFactor::subtract(const Supernode& from, int done, const Supernode& node) {
    int end = done;
    while (end < from.height && from.rows[end] < node.first + node.width) ++end;
    const int columns = end - done, rows = from.height - done;
    double* product = product_.data();
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, columns, from.width, 1.0, from.at(done, 0), from.height, 0.0, product,
                rows);
    if (rows > columns)
        cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, rows - columns, columns, from.width, 1.0, from.at(end, 0), from.height,
                    from.at(done, 0), from.height, 0.0, product + columns, rows);
    for (int i = 0; i < rows; ++i) placeOfRow_[i] = place_[from.rows[done + i]];
    for (int j = 0; j < columns; ++j, product += rows) {
        double* column = node.at(0, placeOfRow_[j]);
        for (int i = j; i < rows; ++i) column[placeOfRow_[i]] -= product[i];
    }
    return end;
}

/// Puts a supernode at the head of the list for the supernode that contains its first unused row.
void SupernodalFactor::wait(std::size_t s, const Supernode& node, int done) {
    int& first = first_[supernodeOf_[node.rows[done]]];
    waiting_[s] = {first, done};
    first = static_cast<int>(s);
}

}  // namespace keyblock
