// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Let L₁ and L₂ be the columns of a supernode in its diagonal block and below, W₁ and
// W₂ the same rows of k ranks, and V = L₁⁻¹·W₁. The new columns are L₁·T and
// (L₂ ± W₂·Vᵀ)·T⁻ᵀ with T·Tᵀ = 1 ± V·Vᵀ. By Woodbury's identity, the ranks that remain
// for the supernodes above are (W₂ − L₂·V)·S⁻ᵀ with S·Sᵀ = 1 ± Vᵀ·V.
#include "solver/engine/step/supernodal_update.h"

#include <Eigen/Cholesky>
#include <cblas.h>

#include <algorithm>
#include <bit>

namespace keyblock {
namespace {

constexpr int leastPanel = 8, mostPanel = 24;  // columns per panel
// ranks per group, one bit of a mask each: the cost of products between ranks grows with the group
constexpr std::size_t groupSize = 32;

/// Inverts a lower triangle in place; the entries above it remain zero.
void invertLower(Eigen::Map<Eigen::MatrixXd> a) {
    const Eigen::Index n = a.rows();
    for (Eigen::Index j = 0; j < n; ++j) {
        a(j, j) = 1.0 / a(j, j);
        for (Eigen::Index i = j + 1; i < n; ++i) a(i, j) *= a(j, j);
        // column j of the inverse is computed from the later columns, which are still those of the factor
        for (Eigen::Index k = j + 1; k < n; ++k) {
            const double x = a(k, j) /= -a(k, k);
            for (Eigen::Index i = k + 1; i < n; ++i) a(i, j) += x * a(i, k);
        }
    }
}

/// Cholesky factor of 1 + sign·V·Vᵀ or of 1 + sign·Vᵀ·V, in the lower triangle of `result` (n×n), with zeros above it.
/// \param v a matrix of `rows` rows and `columns` columns.
bool factorOfSum(CBLAS_TRANSPOSE transpose, double sign, const std::vector<double>& v, int rows, int columns,
                 std::vector<double>& result) {
    const int n = transpose == CblasNoTrans ? rows : columns, k = transpose == CblasNoTrans ? columns : rows;
    result.assign(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), 0.0);
    Eigen::Map<Eigen::MatrixXd> sum(result.data(), n, n);
    sum.diagonal().setOnes();
    cblas_dsyrk(CblasColMajor, CblasLower, transpose, n, k, sign, v.data(), rows, 1.0, result.data(), n);
    return Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(sum).info() == Eigen::Success;
}

int firstRow(const SparseColumn& column) { return std::min_element(column.begin(), column.end())->first; }

}  // namespace

void SupernodalUpdate::analyse(const cholmod_factor& factor) {
    const auto* super = static_cast<const int*>(factor.super);
    supernodeOf_.resize(factor.n);
    for (std::size_t s = 0; s < factor.nsuper; ++s)
        std::fill(supernodeOf_.begin() + super[s], supernodeOf_.begin() + super[s + 1], static_cast<int>(s));
    columns_.assign(factor.n * groupSize, 0.0);
    ranksAt_.assign(factor.nsuper, 0);
}

bool SupernodalUpdate::apply(cholmod_factor& factor, bool add, std::span<const SparseColumn> columns) {
    std::vector<std::pair<int, const SparseColumn*>> sorted;
    for (const SparseColumn& column : columns)
        if (!column.empty()) sorted.emplace_back(firstRow(column), &column);
    // neighbours in elimination order share most of their path to the root
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
    std::vector<const SparseColumn*> group;
    for (std::size_t begin = 0; begin < sorted.size(); begin += groupSize) {
        group.clear();
        for (std::size_t c = begin; c < std::min(begin + groupSize, sorted.size()); ++c) group.push_back(sorted[c].second);
        if (applyGroup(factor, add ? 1.0 : -1.0, group)) continue;
        std::ranges::fill(columns_, 0.0);
        std::ranges::fill(ranksAt_, 0);
        return false;
    }
    return true;
}

bool SupernodalUpdate::applyGroup(cholmod_factor& factor, double sign, std::span<const SparseColumn* const> columns) {
    for (std::size_t r = 0; r < columns.size(); ++r) {
        for (const auto& [row, value] : *columns[r]) columns_[static_cast<std::size_t>(row) * groupSize + r] = value;
        ranksAt_[supernodeOf_[firstRow(*columns[r])]] |= 1u << r;
    }
    for (std::size_t s = 0; s < factor.nsuper; ++s) {
        const std::uint32_t ranks = std::exchange(ranksAt_[s], 0);
        if (ranks == 0) continue;
        const Supernode node = supernode(factor, s);
        gather(node, ranks);
        if (!update(node, sign, std::popcount(ranks))) return false;
        if (node.height == node.width) continue;
        scatter(node, ranks);
        ranksAt_[supernodeOf_[node.rows[node.width]]] |= ranks;
    }
    return true;
}

/// Collects the rows of a supernode, and clears those of its diagonal block, in which nothing will remain.
void SupernodalUpdate::gather(const Supernode& node, std::uint32_t ranks) {
    const std::size_t height = node.height;
    gathered_.resize(height * groupSize);
    for (std::size_t i = 0; i < height; ++i) {
        double* row = &columns_[static_cast<std::size_t>(node.rows[i]) * groupSize];
        double* to = &gathered_[i];
        for (std::uint32_t left = ranks; left != 0; left &= left - 1, to += height) *to = row[std::countr_zero(left)];
        if (i < static_cast<std::size_t>(node.width)) std::fill_n(row, groupSize, 0.0);
    }
}

void SupernodalUpdate::scatter(const Supernode& node, std::uint32_t ranks) {
    const std::size_t below = node.height - node.width;
    for (std::size_t i = 0; i < below; ++i) {
        double* row = &columns_[static_cast<std::size_t>(node.rows[node.width + i]) * groupSize];
        const double* from = &gathered_[i];
        for (std::uint32_t left = ranks; left != 0; left &= left - 1, from += below) row[std::countr_zero(left)] = *from;
    }
}

/// Updates a few columns at a time, because the cost per column increases with the width of a panel.
bool SupernodalUpdate::update(const Supernode& node, double sign, int ranks) {
    const int panel = std::clamp(ranks, leastPanel, mostPanel);
    for (int at = 0; at < node.width; at += panel) {
        const int width = std::min(panel, node.width - at);
        const Panel part{node.values + at * (node.height + 1), node.height, width, node.height - at};
        if (!updatePanel(part, sign, ranks)) return false;
        std::swap(gathered_, left_);
    }
    return true;
}

/// Updates the columns of a panel by the ranks in `gathered_`, which has the rows of the panel. The remainders of the
/// ranks are stored in `left_`.
bool SupernodalUpdate::updatePanel(const Panel& panel, double sign, int ranks) {
    const int n = panel.width;
    const Eigen::Map<const Eigen::MatrixXd> gathered(gathered_.data(), panel.height, ranks);
    scaled_.resize(n * ranks);
    Eigen::Map<Eigen::MatrixXd>(scaled_.data(), n, ranks) = gathered.topRows(n);
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, n, ranks, 1.0, panel.values, panel.stride,
                scaled_.data(), n);
    if (!factorOfSum(CblasNoTrans, sign, scaled_, n, ranks, diagonal_) || !timesDiagonal(panel)) return false;
    if (panel.height == n) return true;
    if (!factorOfSum(CblasTrans, sign, scaled_, n, ranks, mixed_)) return false;
    updateBelow(panel, sign, ranks);
    return true;
}

/// Multiplies by the inverses of the small factors, because the BLAS multiplies faster than it solves.
void SupernodalUpdate::updateBelow(const Panel& panel, double sign, int ranks) {
    const int n = panel.width, h = panel.height, m = h - n, stride = panel.stride;
    invertLower({diagonal_.data(), n, n});
    invertLower({mixed_.data(), ranks, ranks});
    const auto multiply = [](CBLAS_TRANSPOSE transposeB, int rows, int columns, int inner, double alpha, const double* a,
                             int strideA, const double* b, int strideB, double beta, double* c, int strideC) {
        cblas_dgemm(CblasColMajor, CblasNoTrans, transposeB, rows, columns, inner, alpha, a, strideA, b, strideB, beta, c,
                    strideC);
    };
    double* below = panel.values + n;
    const double* ranksBelow = gathered_.data() + n;
    left_.resize(m * ranks);
    work_.resize(m * std::max(n, ranks));
    Eigen::Map<Eigen::MatrixXd>(work_.data(), m, ranks) = Eigen::Map<const Eigen::MatrixXd>(gathered_.data(), h, ranks).bottomRows(m);
    multiply(CblasNoTrans, m, ranks, n, -1.0, below, stride, scaled_.data(), n, 1.0, work_.data(), m);
    multiply(CblasTrans, m, ranks, ranks, 1.0, work_.data(), m, mixed_.data(), ranks, 0.0, left_.data(), m);
    for (int j = 0; j < n; ++j) std::copy_n(below + static_cast<std::ptrdiff_t>(j) * stride, m, &work_[j * m]);
    multiply(CblasTrans, m, n, ranks, sign, ranksBelow, h, scaled_.data(), n, 1.0, work_.data(), m);
    multiply(CblasTrans, m, n, n, 1.0, work_.data(), m, diagonal_.data(), n, 0.0, below, stride);
}

/// Multiplies the diagonal block by T.
/// \return false if the result is not finite.
bool SupernodalUpdate::timesDiagonal(const Panel& panel) const {
    const int n = panel.width;
    Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> own(panel.values, n, n, Eigen::OuterStride<>(panel.stride));
    const Eigen::Map<const Eigen::MatrixXd> factor(diagonal_.data(), n, n);
    for (int j = 0; j < n; ++j)  // in place: column j does not depend on earlier columns
        for (int i = n - 1; i >= j; --i) {
            double sum = 0.0;
            for (int k = j; k <= i; ++k) sum += own(i, k) * factor(k, j);
            own(i, j) = sum;
        }
    return own.diagonal().allFinite();
}

}  // namespace keyblock
