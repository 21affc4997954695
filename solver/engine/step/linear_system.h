// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Symmetric positive definite systems A·x = b, sparse and direct. The pattern is
// fixed once; afterwards an assembly scatters its numbers to places it looked up
// before, which costs far less than building the matrix anew. CHOLMOD does the
// work and stays behind this header. A factor can be followed through small changes
// of its matrix, a few ranks at a time. The same numbers give the same bits on any
// number of threads.
#pragma once

#include "solver/engine/step/sparse_column.h"

#include <memory>
#include <span>
#include <utility>

namespace keyblock {

/// One system with its factor. Not to be used from two threads at once.
class LinearSystem {
public:
    LinearSystem();
    ~LinearSystem();
    LinearSystem(LinearSystem&&) noexcept;
    LinearSystem& operator=(LinearSystem&&) noexcept;

    /// Fixes the pattern of an n×n matrix and orders its unknowns; all values become zero.
    /// \param entries (row, column) of what may differ from zero, from either triangle, in any order, repeated or
    ///        not. The diagonal always belongs to the pattern.
    /// \pre every index lies in 0 … n − 1.
    void analyse(int n, std::span<const std::pair<int, int>> entries);

    /// Number of unknowns; 0 before the first `analyse`.
    int size() const;

    /// Place in `values()` of the entry (i, j), which is that of (j, i) too; good until the next `analyse`.
    /// \pre the pattern holds it.
    int slot(int i, int j) const;

    /// The lower triangle's values, in the order of `slot`: add to `values()[slot(i, j)]`, once for i ≠ j.
    std::span<double> values();

    /// Sets all values to zero and keeps the pattern.
    void clear();

    /// Factors the values as they stand.
    /// \return −1; or, when the matrix is not positive definite to working precision, an unknown that the others leave
    ///         without stiffness: it belongs to the body or the mechanism that is loose.
    /// \throws std::bad_alloc when memory runs out.
    [[nodiscard]] int factor();

    /// Makes the factor that of A + Σ c·cᵀ, or of A − Σ c·cᵀ; `values` stay as they are. Each column takes a fraction of
    /// the work of `factor`.
    /// \return false when the result is not positive definite: the factor is then of no use until the next `factor`.
    /// \pre `factor` returned −1, no call of these has returned false since, and the pattern holds every product of two
    ///      entries of one column.
    [[nodiscard]] bool addRanks(std::span<const SparseColumn> columns);
    [[nodiscard]] bool takeRanks(std::span<const SparseColumn> columns);

    /// Columns that can be added or taken with about half the work of `factor`.
    int worthwhileRanks() const;

    /// Solves with the last factor, then improves the answer by its own residual `refinements` times.
    /// \param rhs, x n values each; they may be the same array only without refinements.
    /// \pre `factor` returned −1; with refinements, neither values nor factor have changed since.
    void solve(std::span<const double> rhs, std::span<double> x, int refinements = 0);

    /// y = A·x with the values as they stand; n values each, different arrays.
    void multiply(std::span<const double> x, std::span<double> y) const;

    /// Entries of the factor, zeros that it stores included: what memory and time grow with.
    double factorEntries() const;

private:
    struct Detail;
    std::unique_ptr<Detail> detail_;
};

}  // namespace keyblock
