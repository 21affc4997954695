// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The matrix of a step, inertia and elasticity of the bodies and a rank for every
// link that resists: K + Σ wᵢ gᵢ gᵢᵀ. Where few weights differ from those in the
// factor it is updated rank by rank, else made again in full; counted work decides,
// never a clock.
#pragma once

#include "solver/engine/step/linear_system.h"
#include "solver/engine/step/link_rows.h"
#include "solver/results/step_work.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace keyblock {

class StepMatrix {
public:
    /// Begins a step: pattern and order are kept from the last one where they hold all of its links.
    void begin(const StepProblem& problem, const LinkRows& rows);

    /// Makes the factor for these weights, one per link and none negative [N/m].
    /// \return −1; or an unknown that the others leave without stiffness.
    [[nodiscard]] int factor(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                             StepWork& work);

    /// Has the next factor made in full, whatever changes: steps at rest resist some motions so little that the digits
    /// which rank updates lose would show.
    void forget() { current_ = false; }

    /// Displacement under `force` by the last factor (both padded); prescribed unknowns get none.
    /// \pre `factor` returned −1.
    Eigen::VectorXd solve(const Eigen::VectorXd& force, StepWork& work);

    /// Entries of the last factor, zeros that it stores included.
    double factorEntries() const { return system_.factorEntries(); }

private:
    using Slots = std::array<int, 36>;

    void fixPattern(const StepProblem& problem, std::vector<std::pair<int, int>> pairs);
    void findSlots(const StepProblem& problem);
    void assemble(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights);
    int factorInFull(const StepProblem& problem, const LinkRows& rows, std::span<const double> weights,
                     StepWork& work);
    bool update(const LinkRows& rows, std::span<const double> weights, StepWork& work);
    std::vector<SparseColumn> columnsOf(const LinkRows& rows, std::span<const int> links,
                                        std::span<const double> changes) const;
    int pairOf(int first, int second) const;

    LinearSystem system_;
    std::vector<char> known_;
    std::vector<std::pair<int, int>> pairs_;  // bodies that share an entry, sorted
    std::vector<int> equations_;  // per padded unknown; −1 where prescribed
    std::vector<int> unknownOf_;  // per equation
    std::vector<Slots> slots_;  // per pair: of its 6 × 6 entries in the lower triangle; −1: not stored
    std::vector<std::array<int, 3>> linkPairs_;  // rows of `pairs_`: a with itself, b with itself, both
    bool current_ = false;  // the factor is of this step
    std::vector<double> inFactor_;  // weights of its links there
    std::vector<double> right_, left_;
};

}  // namespace keyblock
