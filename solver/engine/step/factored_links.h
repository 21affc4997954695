// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The links as the factor of a step's matrix has them, with the weights and gradients
// of the step in which each was put in. From step to step links are found again by
// what they connect; what has changed since is a rank to add to the factor, or to take
// from it.
#pragma once

#include "solver/engine/step/link_rows.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace keyblock {

/// A link in the factor.
struct FactoredLink {
    double weight = 0.0;  // [N/m]; 0: not in the factor
    int firstA = 0, firstB = 0;  // padded unknowns
    std::array<double, 12> gradient{};
};

class FactoredLinks {
public:
    struct Changes {
        std::vector<FactoredLink> add, take;
        bool rounded = false;  // a weight that is nearly that of the factor is left as it is there
        std::size_t count() const { return add.size() + take.size(); }
    };

    /// Finds the links of a new step among those in the factor.
    /// \return whether they are the same links in the same order.
    bool begin(const StepProblem& problem, const LinkRows& rows);

    /// What turns the factor into one for these weights, one per link of the step.
    Changes changesTo(const LinkRows& rows, std::span<const double> weights) const;

    /// Notes that the factor has been changed by `changesTo`, or has been made in full.
    void change(const LinkRows& rows, std::span<const double> weights);
    void renew(const LinkRows& rows, std::span<const double> weights);

    /// Weight in the factor of a link of the step [N/m].
    double weight(std::size_t link) const { return links_[link].weight; }

private:
    std::vector<std::uint64_t> keys_;  // of the step's links
    std::vector<FactoredLink> links_;  // per link of the step
    std::vector<FactoredLink> ended_;  // in the factor, but not of this step
};

}  // namespace keyblock
