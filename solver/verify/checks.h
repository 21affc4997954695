// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects the computed and expected values of one case.
#pragma once

#include "solver/verify/verify.h"

#include <chrono>
#include <string>
#include <vector>

namespace keyblock {

class Checks {
public:
    explicit Checks(std::string name) : name_(std::move(name)) {}

    /// Checks that `measured` differs from `expected` by at most `tolerance` times `expected`.
    void relative(const std::string& quantity, double measured, double expected, double tolerance);

    /// Checks that `measured` differs from `expected` by at most `tolerance`, given in the unit of the quantity.
    void absolute(const std::string& quantity, double measured, double expected, double tolerance);

    std::vector<CaseResult> take() { return std::move(results_); }

private:
    void add(const std::string& quantity, double measured, double expected, double tolerance, bool relative);

    using Clock = std::chrono::steady_clock;
    std::string name_;
    std::vector<CaseResult> results_;
    Clock::time_point last_ = Clock::now();
};

}  // namespace keyblock
