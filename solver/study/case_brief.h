// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the status of a sweep needs of a finished case, found in its summary without
// reading all of it: a sweep may have a hundred thousand cases.
#pragma once

#include "solver/study/case_result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace keyblock {

struct CaseBrief {
    CaseOutcome outcome = CaseOutcome::Done;
    std::optional<bool> fails;
    double cpuSeconds = 0.0;
};

/// The brief of a summary. None if there is no such file, or if it is not exactly as `writeCaseResult` writes it for this
/// plan; `readCaseResult` then says what it is.
std::optional<CaseBrief> readCaseBrief(const std::filesystem::path& file, const std::string& sweep);

}  // namespace keyblock
