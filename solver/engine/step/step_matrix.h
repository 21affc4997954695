// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The matrix of a step, inertia and elasticity of the bodies and a rank for every
// link that resists: K + Σ wᵢ gᵢ gᵢᵀ. Its factor is kept within the step and, in
// motion, from step to step. Where few links differ from those in the factor it is
// updated rank by rank, else made again in full; counted work decides, never a clock.
// A factor that was kept holds gradients that have turned a little since, so its
// solutions need a few iterations (`coupledDirection`).
#pragma once

#include "solver/engine/step/factored_links.h"
#include "solver/engine/step/linear_system.h"
#include "solver/engine/step/link_rows.h"
#include "solver/results/step_work.h"

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace keyblock {

class StepMatrix {
public:
    /// Begins a step: pattern, order and factor are kept from the last one where they hold for this one too.
    void begin(const StepProblem& problem, const LinkRows& rows);

    /// Makes the factor for these weights, one per link and none negative [N/m].
    /// \return −1; or an unknown that the others leave without stiffness.
    [[nodiscard]] int factor(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                             StepWork& work);

    /// Weight of a link in the present factor [N/m]; none without a factor.
    std::optional<double> weightInFactor(std::size_t link) const {
        return current_ ? std::optional(links_.weight(link)) : std::nullopt;
    }

    /// True where the factor is that of the matrix, except for round-off.
    bool exact() const { return exact_; }

    /// Has the next factor made in full, whatever changes: because this one has grown too poor.
    void forget() { current_ = false; }

    /// The matrix for the last weights times `x` (both padded); rows of prescribed unknowns have no meaning.
    /// Leaves the links' strains under `x` in `rates`.
    Eigen::VectorXd product(const StepProblem& problem, const LinkRows& rows, const Eigen::VectorXd& x,
                            std::vector<double>& rates) const;

    /// Displacement under `force` by the last factor (both padded); prescribed unknowns get none.
    /// \pre `factor` returned −1.
    Eigen::VectorXd solve(const Eigen::VectorXd& force, StepWork& work);

    /// Entries of the last factor, zeros that it stores included.
    double factorEntries() const { return system_.factorEntries(); }

private:
    using Slots = std::array<int, 36>;

    bool keepsPattern(const StepProblem& problem, const std::vector<std::pair<int, int>>& pairs) const;
    void fixPattern(const StepProblem& problem, std::vector<std::pair<int, int>> pairs);
    void findSlots(const StepProblem& problem);
    void findLinkPairs(const StepProblem& problem);
    bool keepsBodies(const StepProblem& problem) const;
    void assemble(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights);
    int factorInFull(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                     StepWork& work);
    bool update(const LinkRows& rows, std::span<const double> weights, StepWork& work);
    std::vector<SparseColumn> columnsOf(std::span<const FactoredLink> links) const;
    int pairOf(int a, int b) const;

    LinearSystem system_;
    std::vector<char> known_;
    std::vector<std::pair<int, int>> pairs_;  // bodies that share an entry, sorted
    std::vector<int> equations_;  // per padded unknown; −1 where prescribed
    std::vector<int> unknownOf_;  // per equation
    std::vector<int> own_;  // per body: row of `pairs_` with itself
    std::vector<Slots> slots_;  // per pair: of its 6 × 6 entries in the lower triangle, by columns; −1: not stored
    std::vector<Matrix6> sums_;  // per pair: its entries
    std::vector<int> linkPairs_;  // per link: row of `pairs_`; −1: of one body
    bool current_ = false;  // there is a factor that can be updated
    bool exact_ = false;
    FactoredLinks links_;
    std::vector<Matrix6> blocks_;  // stiffness of the bodies in the factor
    std::vector<Eigen::Vector3d> nodes_;
    std::vector<double> weights_;  // given last
    std::vector<double> right_, left_;
};

}  // namespace keyblock
