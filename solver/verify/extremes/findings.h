// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects what is measured in a run at an extreme, and what it should be.
#pragma once

#include <string>
#include <vector>

namespace keyblock {

struct Finding {
    std::string quantity;  // with its unit
    double measured = 0.0, expected = 0.0;
    double tolerance = 0.0;  // in the unit of the quantity

    /// Deviation over tolerance; infinite if the measured value is not a number.
    double excess() const;
};

class Findings {
public:
    /// `measured` may differ from `expected` by `tolerance`, in the unit of the quantity.
    void near(const std::string& quantity, double measured, double expected, double tolerance);

    /// `measured` may exceed `limit` by `tolerance`.
    void atMost(const std::string& quantity, double measured, double limit, double tolerance);

    /// A condition that must be met.
    void holds(const std::string& condition, bool met);

    bool allRight() const;

    /// The finding with the largest excess. \pre there is one.
    const Finding& worst() const;
    bool isEmpty() const { return all_.empty(); }

private:
    std::vector<Finding> all_;
};

}  // namespace keyblock
