// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The matrix of a step, K + Σ wᵢ gᵢ gᵢᵀ: inertia and elasticity of the bodies plus a
// rank-one term for every link with stiffness. Its factor is kept within the step and
// from step to step. If few links differ from those in the factor it is
// updated rank by rank, otherwise it is recomputed. The choice depends on a count of
// operations, never on measured time. The gradients in a factor that was kept are
// slightly out of date, so solutions with it need a few iterations
// (`coupledDirection`).
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

/// For the order of elimination, a group for each unknown that is not prescribed, by nested dissection of the bodies that
/// have one; empty if these are fewer than 4,000 or `StepProblem::places` is.
std::vector<int> eliminationGroups(const StepProblem& problem);

class StepMatrix {
public:
    /// Begins a step. The pattern, ordering and factor of the previous step are kept if they are still valid.
    void begin(const StepProblem& problem, const LinkRows& rows);

    /// Updates or recomputes the factor.
    /// \param weights one non-negative weight per link of the step [N/m].
    /// \return −1 on success, otherwise the index of an unknown without stiffness.
    [[nodiscard]] int factor(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                             StepWork& work);

    /// Weight of a link in the current factor [N/m]; none if there is no factor.
    std::optional<double> weightInFactor(std::size_t link) const {
        return current_ ? std::optional(links_.weight(link)) : std::nullopt;
    }

    /// True if the factor matches the current matrix to within round-off.
    bool exact() const { return exact_; }

    /// Makes the next call of `factor` recompute the factor in full. Used when the current factor has become too
    /// inaccurate.
    void forget() { current_ = false; }

    /// Product of the matrix and `x`, with the weights of the last call of `factor`. `x` and the result are padded. In
    /// the result, the entries of prescribed unknowns have no meaning.
    /// \param rates receives the links' strain increments due to `x`.
    Eigen::VectorXd product(const StepProblem& problem, const LinkRows& rows, const Eigen::VectorXd& x,
                            std::vector<double>& rates) const;

    /// Displacement under `force`, solved with the last factor. Both vectors are padded. The displacement is zero for
    /// prescribed unknowns.
    /// \pre `factor` returned −1.
    Eigen::VectorXd solve(const Eigen::VectorXd& force, StepWork& work);

    /// Number of entries of the last factor, including stored zeros.
    double factorEntries() const { return system_.factorEntries(); }

private:
    using Slots = std::array<int, 36>;

    bool keepsPattern(const StepProblem& problem, const std::vector<std::pair<int, int>>& pairs) const;
    bool keepsUnknowns(const StepProblem& problem) const;
    void findIdle(const StepProblem& problem);
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
    std::vector<char> patternKnown_;  // per unknown: it was prescribed when the pattern was fixed, and has no equation
    std::vector<char> known_;  // per unknown: it is prescribed in this step
    std::vector<int> idle_;  // equations of unknowns that are prescribed in this step: nodes of lost or removed bolts
    std::vector<std::pair<int, int>> pairs_;  // pairs of bodies with non-zero entries, sorted
    std::vector<int> equations_;  // per padded unknown: its equation; −1: none
    std::vector<int> unknownOf_;  // per equation: its unknown
    std::vector<int> own_;  // per body: row of `pairs_` of the body with itself
    std::vector<Slots> slots_;  // per pair: slots of its 6 × 6 lower-triangle entries, by columns; −1: not stored
    std::vector<Matrix6> sums_;  // per pair: its 6 × 6 entries
    std::vector<int> linkPairs_;  // per link: row of `pairs_`; −1: the link acts on one body only
    bool current_ = false;  // a factor exists that can be updated
    bool exact_ = false;
    FactoredLinks links_;
    std::vector<Matrix6> blocks_;  // block stiffness in the factor
    std::vector<Eigen::Vector3d> nodes_;  // bolt-node stiffness in the factor
    std::vector<double> weights_;  // weights of the last call of `factor`
    std::vector<double> right_, left_;
};

}  // namespace keyblock
