// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The links as they are contained in the factor of a step's matrix, each with the
// weight and gradient of the step in which it was added. From step to step, links are
// identified by the bodies and features that they connect. Each change since then is a
// rank-one update or downdate of the factor.
#pragma once

#include "solver/engine/step/link_rows.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace keyblock {

/// A link as it is contained in the matrix factor.
struct FactoredLink {
    double weight = 0.0;  // [N/m]; 0: not in the factor
    int firstA = 0, firstB = 0;  // padded unknowns
    std::array<double, 12> gradient{};
};

class FactoredLinks {
public:
    struct Changes {
        std::vector<FactoredLink> add, take;  // rank-one terms to add to the factor and to remove from it
        bool rounded = false;  // some weight differs slightly from that in the factor, which is kept
        std::size_t count() const { return add.size() + take.size(); }
    };

    /// Matches the links of a new step with the links in the factor.
    /// \return true if the new step has the same links as the previous one, in the same order.
    bool begin(const StepProblem& problem, const LinkRows& rows);

    /// Changes that update the factor to new weights and to the current gradients.
    /// \param weights one weight per link of the step [N/m].
    Changes changesTo(const LinkRows& rows, std::span<const double> weights) const;

    /// Record that the factor now contains these weights: `change` after the changes from `changesTo` were applied,
    /// `renew` after the factor was recomputed in full.
    void change(const LinkRows& rows, std::span<const double> weights);
    void renew(const LinkRows& rows, std::span<const double> weights);

    /// Weight that a link of the step has in the factor [N/m]; 0 if it is not in the factor.
    double weight(std::size_t link) const { return links_[link].weight; }

private:
    void matchLinks(std::vector<std::uint64_t> keys);
    bool isAsNow(std::size_t i, double weight) const;

    std::vector<std::uint64_t> keys_;  // per link of the step
    std::vector<FactoredLink> links_;  // per link of the step
    std::vector<char> turned_;  // per link of the step: its gradient differs from that in the factor
    std::vector<FactoredLink> ended_;  // in the factor, but no longer in the step
};

}  // namespace keyblock
