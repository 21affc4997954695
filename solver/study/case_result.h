// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a case of a sweep gives, and its file.
#pragma once

#include "solver/results/quantity.h"
#include "solver/study/bolt_faults.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// `done`: every stage ended as planned or unstable. The others have a reason.
enum class CaseOutcome { Done, Invalid, NumericalFailure, Limit, Undecided, Error };

std::string_view wordOf(CaseOutcome outcome);

struct SweepCaseResult {
    long number = 0;
    CaseOutcome outcome = CaseOutcome::Done;
    std::string reason;  // why it is not done; empty otherwise
    std::optional<bool> stands, fails;
    std::vector<Measurement> values;  // one for each quantity of the sweep
    std::optional<double> safetyLower, safetyUpper;  // bracket of the factor of safety
    std::vector<double> faultMeasures;  // one for each fault of the study
    std::vector<BoltFault> faults;
    long steps = 0;
    // not part of the results
    double cpuSeconds = 0.0, wallSeconds = 0.0;  // of the process that finished the case
    std::string host;
};

/// Writes summary.json. \param sweep the hash of the plan. \throws CannotWrite
void writeCaseResult(const std::filesystem::path& file, const SweepCaseResult& result, const std::string& sweep,
                     const std::vector<std::string>& quantities);

/// Reads summary.json. None if there is no such file.
/// \throws CannotRead if it is damaged or belongs to another plan
std::optional<SweepCaseResult> readCaseResult(const std::filesystem::path& file, const std::string& sweep,
                                              std::size_t quantities);

}  // namespace keyblock
