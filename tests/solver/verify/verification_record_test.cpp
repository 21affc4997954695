// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The record of a verification is read back as written; a statement never claims more
// than the record of this build says.
#include "solver/verify/verification_record.h"

#include "solver/files/run_store/build_id.h"
#include "solver/run/write_error.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace keyblock {
namespace {

VerificationRecord recordOfThisBuild() { return {std::string(buildId()), "0.1.0", "2026-01-31", 64, 212, 0}; }

TEST(VerificationRecord, IsReadBackAsWritten) {
    const test::ScratchFolder folder;
    const auto file = folder.path() / "data" / "keyblock" / "verification.json";
    EXPECT_FALSE(readVerificationRecord(file));
    writeVerificationRecord(recordOfThisBuild(), file);  // creates the folder
    EXPECT_EQ(readVerificationRecord(file), recordOfThisBuild());
    const std::string whole = test::contentOf(file);
    for (const std::string& damaged :
         {whole.substr(0, whole.size() / 2), std::string("{}"), std::string("[1]"), std::string()}) {
        test::putContent(file, damaged);
        EXPECT_FALSE(readVerificationRecord(file)) << damaged;
    }
    test::putContent(folder.path() / "file", "");
    EXPECT_THROW(writeVerificationRecord(recordOfThisBuild(), folder.path() / "file" / "verification.json"),
                 CannotWrite);
}

TEST(VerificationRecord, StatesWhatItSays) {
    EXPECT_EQ(verificationStatement(std::nullopt),
              "Not verified on this installation. Run 'keyblock verify' to verify it.");
    VerificationRecord record = recordOfThisBuild();
    EXPECT_EQ(verificationStatement(record),
              "Verified on this installation on 2026-01-31: all 212 values of 64 cases agree with their references.");
    record.missed = 3;
    EXPECT_TRUE(
        verificationStatement(record).starts_with("Verification missed on this installation on 2026-01-31: 3 of "));
    record.build = "another";
    EXPECT_TRUE(verificationStatement(record).starts_with("Not verified on this installation: "));
}

TEST(VerificationRecord, LiesInTheFolderForDataOfTheUser) {
    const char* before = std::getenv("XDG_DATA_HOME");
    const std::string kept = before ? before : "";
    ::setenv("XDG_DATA_HOME", "/somewhere/data", 1);
    EXPECT_EQ(verificationRecordPath(), "/somewhere/data/keyblock/verification.json");
    ::setenv("XDG_DATA_HOME", "not/absolute", 1);
    EXPECT_NE(verificationRecordPath(), "not/absolute/keyblock/verification.json");
    if (before) ::setenv("XDG_DATA_HOME", kept.c_str(), 1);
    else ::unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace keyblock
