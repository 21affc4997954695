// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/force_trend.h"

#include "solver/engine/step/link_keys.h"

#include <cstddef>
#include <utility>

namespace keyblock {
namespace {

// Fraction of the last change that is added. With all of it, waves that turn back are overestimated.
constexpr double continued = 0.7;

}  // namespace

void ForceTrend::predict(const StepProblem& problem, std::vector<double>& forces) {
    std::vector<std::uint64_t> keys;
    std::vector<double> now;
    std::vector<std::size_t> links;
    for (std::size_t i = 0; i < problem.links.size(); ++i) {
        if (!ofContact(problem.links[i].kind)) continue;
        keys.push_back(keyOf(problem.links[i]));
        now.push_back(forces[i]);
        links.push_back(i);
    }
    alignRows(keys_, keys, [&](std::size_t before, std::size_t row) {
        forces[links[row]] += continued * (now[row] - forces_[before]);
    });
    keys_ = std::move(keys);
    forces_ = std::move(now);
    isCurrent_ = true;
}

void ForceTrend::endStep() {
    if (!std::exchange(isCurrent_, false)) keys_.clear();
}

}  // namespace keyblock
