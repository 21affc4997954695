// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/verification_record.h"

#include "solver/files/atomic_file.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/build_id.h"
#include "solver/files/text_file.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <system_error>

namespace keyblock {

namespace {

constexpr const char* recordFormat = "keyblock-verification";
constexpr std::uint64_t longestRecord = 1 << 16;  // [bytes]

/// An absolute path in an environment variable; empty if there is none.
std::filesystem::path folderIn(const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path path = value ? value : "";
    return path.is_absolute() ? path : std::filesystem::path();
}

}  // namespace

std::filesystem::path verificationRecordPath() {
    std::filesystem::path data = folderIn("XDG_DATA_HOME");
    if (data.empty() && !folderIn("HOME").empty()) data = folderIn("HOME") / ".local" / "share";
    return data.empty() ? data : data / "keyblock" / "verification.json";
}

void writeVerificationRecord(const VerificationRecord& record, const std::filesystem::path& path) {
    std::error_code ignored;  // writing the file reports what is wrong
    std::filesystem::create_directories(path.parent_path(), ignored);
    const nlohmann::ordered_json json{{"format", recordFormat}, {"build", record.build}, {"version", record.version},
                                      {"date", record.date},    {"cases", record.cases}, {"numbers", record.numbers},
                                      {"missed", record.missed}};
    writeAtomically(path, [&](std::ostream& out) { out << json.dump(2) << "\n"; });
}

std::optional<VerificationRecord> readVerificationRecord(const std::filesystem::path& path) {
    try {
        const auto json = nlohmann::json::parse(readTextFile(path, {longestRecord, "", ""}));
        if (json.at("format") != recordFormat) return std::nullopt;
        return VerificationRecord{json.at("build"), json.at("version"), json.at("date"),
                                  json.at("cases"), json.at("numbers"), json.at("missed")};
    } catch (const CannotRead&) {
        return std::nullopt;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

std::string verificationStatement(const std::optional<VerificationRecord>& record) {
    const std::string remedy = " Run 'keyblock verify' to verify it.";
    if (!record) return "Not verified on this installation." + remedy;
    if (record->build != buildId())
        return "Not verified on this installation: the last verification, on " + record->date +
               ", was of another build." + remedy;
    const std::string when = " on this installation on " + record->date + ": ";
    const std::string all = std::to_string(record->numbers) + " values of " + std::to_string(record->cases) + " cases";
    if (record->missed == 0) return "Verified" + when + "all " + all + " agree with their references.";
    return "Verification missed" + when + std::to_string(record->missed) + " of the " + all +
           " are outside their tolerances. Run 'keyblock verify' to list them.";
}

}  // namespace keyblock
