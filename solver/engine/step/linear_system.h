// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Direct solution of sparse symmetric positive definite systems A·x = b. The pattern
// is fixed once; each assembly then writes its values to positions found beforehand,
// which is much cheaper than rebuilding the matrix. CHOLMOD does the work and is
// hidden behind this header. A factor can be updated for small changes of its matrix,
// a few ranks at a time. The same input gives bitwise identical results on any number
// of threads.
#pragma once

#include "solver/engine/step/sparse_column.h"

#include <memory>
#include <span>
#include <utility>

namespace keyblock {

/// A linear system together with its factor. Not thread-safe.
class LinearSystem {
public:
    LinearSystem();
    ~LinearSystem();
    LinearSystem(LinearSystem&&) noexcept;
    LinearSystem& operator=(LinearSystem&&) noexcept;

    /// Fixes the pattern of an n×n matrix and orders its unknowns; all values become zero.
    /// \param entries the (row, column) pairs of entries that may be non-zero, from either triangle, in any order and
    ///        with repetitions allowed. The diagonal is always part of the pattern.
    /// \param groups a group for each unknown, e.g. by nested dissection; empty: none. The groups are eliminated in
    ///        ascending order if that needs clearly fewer operations than an order of minimum degree.
    /// \pre every index and every group lies in 0 … n − 1.
    void analyse(int n, std::span<const std::pair<int, int>> entries, std::span<const int> groups = {});

    /// Number of unknowns; 0 before the first `analyse`.
    int size() const;

    /// Index in `values()` of the entry (i, j), which is also that of (j, i). It is valid until the next `analyse`.
    /// \pre the pattern contains the entry.
    int slot(int i, int j) const;

    /// Values of the lower triangle, indexed by `slot`. Because (i, j) and (j, i) share one value, add to it only once.
    std::span<double> values();

    /// Sets all values to zero and keeps the pattern.
    void clear();

    /// Factors the matrix with its current values.
    /// \return −1 on success. If the matrix is not positive definite to working precision, the index of an unknown
    ///         without stiffness, which belongs to a loose body or a mechanism.
    /// \throws std::bad_alloc if memory runs out.
    [[nodiscard]] int factor();

    /// Turn the factor of A into the factor of A + Σ c·cᵀ (`addRanks`) or A − Σ c·cᵀ (`takeRanks`), summed over the
    /// vectors c in `columns`. The matrix values are not changed. Adding or removing a column takes a fraction of the
    /// time that `factor` takes.
    /// \return false if the result is not positive definite; the factor is then invalid until the next `factor`.
    /// \pre `factor` returned −1, neither function has returned false since, and for every c in `columns` the matrix
    ///      pattern contains all non-zero entries of c·cᵀ.
    [[nodiscard]] bool addRanks(std::span<const SparseColumn> columns);
    [[nodiscard]] bool takeRanks(std::span<const SparseColumn> columns);

    /// Number of columns that can be added or removed in about half the time that `factor` takes.
    int worthwhileRanks() const;

    /// Solves A·x = rhs with the last factor, followed by `refinements` steps of iterative refinement.
    /// \param rhs the right-hand side, n values.
    /// \param x the solution, n values; must be a different array from `rhs` unless `refinements` is 0.
    /// \pre `factor` returned −1. Unless `refinements` is 0, the values and the factor have not changed since.
    void solve(std::span<const double> rhs, std::span<double> x, int refinements = 0);

    /// Computes y = A·x with the current values. `x` and `y` must be different arrays of n values each.
    void multiply(std::span<const double> x, std::span<double> y) const;

    /// Number of entries of the factor, including stored zeros; a measure of memory and run time.
    double factorEntries() const;

private:
    struct Detail;
    std::unique_ptr<Detail> detail_;
};

}  // namespace keyblock
