// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/verification_note.h"

#include "app/cli/output.h"
#include "solver/files/program_version.h"
#include "solver/files/run_store/build_id.h"
#include "solver/run/write_error.h"
#include "solver/verify/verification_record.h"

#include <algorithm>
#include <array>
#include <ctime>

namespace keyblock::cli {

namespace {

std::string todayInUtc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 16> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts)};
}

}  // namespace

void recordVerification(std::span<const CaseResult> results, std::size_t cases) {
    const std::filesystem::path path = verificationRecordPath();
    VerificationRecord record{std::string(buildId()), std::string(programVersion()), todayInUtc()};
    record.cases = static_cast<long>(cases);
    record.numbers = static_cast<long>(results.size());
    record.missed = std::ranges::count(results, false, &CaseResult::passed);
    try {
        if (path.empty()) throw CannotWrite("there is no folder for data; set XDG_DATA_HOME or HOME");
        writeVerificationRecord(record, path);
    } catch (const CannotWrite& error) {
        printToError("warning: the verification is not recorded for reports: " + std::string(error.what()) + "\n");
    }
}

}  // namespace keyblock::cli
