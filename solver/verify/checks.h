// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects the numbers of one case with their expected values.
#pragma once

#include "solver/verify/verify.h"

#include <chrono>
#include <string>
#include <vector>

namespace keyblock {

class Checks {
public:
    explicit Checks(std::string name) : name_(std::move(name)) {}

    /// Within `tolerance` of `expected`, as a fraction of it.
    void relative(const std::string& quantity, double measured, double expected, double tolerance);

    /// Within `tolerance` of `expected`, in the quantity's unit.
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
