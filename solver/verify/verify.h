// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program checks itself against numbers that were found without it: closed
// forms, independent references and the published tables. The command line
// prints this list; each case is also a test.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// One number of a case and its expected value.
struct CaseResult {
    std::string name;  // of the case
    std::string quantity;  // what was measured, with its unit
    double measured = 0.0;
    double expected = 0.0;
    double tolerance = 0.0;  // of `expected` when `relative`, else in the quantity's unit
    bool relative = true;
    bool passed = false;
    double seconds = 0.0;  // [s] that the measurement took
};

/// A case of the suite; `run` solves it and measures, blocking.
struct Case {
    std::string name;
    std::string description;
    std::function<std::vector<CaseResult>()> run;
};

/// The whole suite, in the order in which it is printed.
const std::vector<Case>& cases();

/// One row of a published table: the paper's number, the independent reference's and the program's.
struct PaperRow {
    std::string quantity;
    std::string unit;
    std::optional<double> paper;  // null: the paper does not give it
    std::optional<double> reference;  // null: none was worked out
    double keyblock = 0.0;
    double tolerance = 0.0;  // relative, against `reference`
    bool passed = false;
};

struct PaperTable {
    std::string title;
    std::vector<PaperRow> rows;
};

/// The paper's tables, solved afresh, blocking.
std::vector<PaperTable> paperTables();

}  // namespace keyblock
