// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/checks.h"

#include <cmath>

namespace keyblock {

void Checks::relative(const std::string& quantity, double measured, double expected, double tolerance) {
    add(quantity, measured, expected, tolerance, true);
}

void Checks::absolute(const std::string& quantity, double measured, double expected, double tolerance) {
    add(quantity, measured, expected, tolerance, false);
}

void Checks::add(const std::string& quantity, double measured, double expected, double tolerance, bool relative) {
    const Clock::time_point now = Clock::now();
    const double allowed = relative ? tolerance * std::abs(expected) : tolerance;
    const bool passed = std::abs(measured - expected) <= allowed;  // false for NaN
    results_.push_back({name_, quantity, measured, expected, tolerance, relative, passed,
                        std::chrono::duration<double>(now - last_).count()});
    last_ = now;
}

}  // namespace keyblock
