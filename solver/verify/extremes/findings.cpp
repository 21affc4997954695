// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
#include "solver/verify/extremes/findings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {

double Finding::excess() const {
    const double deviation = std::abs(measured - expected);
    if (!std::isfinite(deviation)) return std::numeric_limits<double>::infinity();
    if (deviation <= tolerance) return tolerance > 0.0 ? deviation / tolerance : 0.0;
    return tolerance > 0.0 ? deviation / tolerance : std::numeric_limits<double>::infinity();
}

void Findings::near(const std::string& quantity, double measured, double expected, double tolerance) {
    all_.push_back({quantity, measured, expected, tolerance});
}

void Findings::atMost(const std::string& quantity, double measured, double limit, double tolerance) {
    all_.push_back({quantity, measured, measured <= limit ? measured : limit, tolerance});
}

void Findings::holds(const std::string& condition, bool met) { all_.push_back({condition, met ? 1.0 : 0.0, 1.0, 0.5}); }

bool Findings::allRight() const {
    return std::all_of(all_.begin(), all_.end(), [](const Finding& finding) { return finding.excess() <= 1.0; });
}

const Finding& Findings::worst() const {
    return *std::max_element(all_.begin(), all_.end(),
                             [](const Finding& a, const Finding& b) { return a.excess() < b.excess(); });
}

}  // namespace keyblock
