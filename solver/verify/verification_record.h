// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The record of the last complete verification on this installation, kept in the user's
// data folder, so that reports can say whether the program that wrote them was verified.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace keyblock {

struct VerificationRecord {
    std::string build;  // `buildId()` of the program
    std::string version;  // `programVersion()` of the program
    std::string date;  // day of the verification, UTC: 2026-01-31
    long cases = 0;
    long numbers = 0;  // values compared with their references
    long missed = 0;  // of these, values outside their tolerances, and cases that did not run

    bool operator==(const VerificationRecord&) const = default;
};

/// `$XDG_DATA_HOME/keyblock/verification.json`, or `~/.local/share/keyblock/verification.json` if that variable is
/// unset or not an absolute path; empty if there is no home folder either.
std::filesystem::path verificationRecordPath();

/// Writes the record, creating its folder if necessary. \throws CannotWrite
void writeVerificationRecord(const VerificationRecord& record, const std::filesystem::path& path);

/// The record in the file; none if the file does not exist or cannot be read as a record.
std::optional<VerificationRecord> readVerificationRecord(const std::filesystem::path& path);

/// Sentence for reports on whether this build of the program was verified, such as "Verified on this installation on
/// 2026-01-31: all 212 values of 64 cases agree with their references." Without a record, or with one of another build,
/// it begins with "Not verified on this installation".
std::string verificationStatement(const std::optional<VerificationRecord>& record);

}  // namespace keyblock
