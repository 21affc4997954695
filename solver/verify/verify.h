// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Verification suite: the program is checked against independent numbers, namely
// closed-form solutions, independent reference calculations and published tables. The
// command line prints the results; each case is also a test.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// A measured value of a case, with its expected value.
struct CaseResult {
    std::string name;  // name of the case
    std::string quantity;  // quantity measured, with its unit
    double measured = 0.0;
    double expected = 0.0;
    double tolerance = 0.0;  // as a fraction of `expected` if `relative`, otherwise in the unit of the quantity
    bool relative = true;
    bool passed = false;
    double seconds = 0.0;  // time taken by the measurement [s]
};

/// A case of the suite. `run` solves the case and returns its results.
struct Case {
    std::string name;
    std::string description;
    std::function<std::vector<CaseResult>()> run;
};

/// The whole suite, in the order in which it is printed.
const std::vector<Case>& cases();

/// One row of a published table, with the values of the paper, the independent reference and the program.
struct PaperRow {
    std::string quantity;
    std::string unit;
    std::optional<double> paper;  // null: the paper does not give it
    std::optional<double> reference;  // null: there is no independent reference
    double keyblock = 0.0;
    double tolerance = 0.0;  // relative, against `reference`
    bool passed = false;
};

struct PaperTable {
    std::string title;
    std::vector<PaperRow> rows;
};

/// The tables of the paper. Each call solves all their cases to compute the program's values.
std::vector<PaperTable> paperTables();

}  // namespace keyblock
