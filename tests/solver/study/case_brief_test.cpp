// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The brief of a case is that of its whole summary, also with names that look like its
// members; anything else is left to the full reader.
#include "solver/study/case_brief.h"

#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace keyblock {
namespace {

class CaseBriefs : public testing::Test {
protected:
    void write(const SweepCaseResult& result) { writeCaseResult(file_, result, "plan", {"max key.u"}); }

    test::ScratchFolder folder_;
    std::filesystem::path file_ = folder_.path() / "summary.json";
};

TEST_F(CaseBriefs, AgreeWithTheWholeSummary) {
    for (const CaseOutcome outcome : {CaseOutcome::Done, CaseOutcome::Limit, CaseOutcome::Error})
        for (const std::optional<bool> fails : {std::optional<bool>(), std::optional(true), std::optional(false)}) {
            SweepCaseResult result;
            result.number = 7;
            result.outcome = outcome;
            result.fails = fails;
            result.reason = "text\n \"fails\": true,\n \"cpu_s\": 9";  // as lines they would be members
            result.host = "h\n \"outcome\": \"invalid\"";
            result.values = {{0.25, "", {}}};
            result.cpuSeconds = 0.1 + 0.2;
            write(result);
            const auto brief = readCaseBrief(file_, "plan");
            const auto whole = readCaseResult(file_, "plan", 1);
            ASSERT_TRUE(brief && whole);
            EXPECT_EQ(brief->outcome, whole->outcome);
            EXPECT_EQ(brief->fails, whole->fails);
            EXPECT_EQ(brief->cpuSeconds, whole->cpuSeconds);
        }
}

TEST_F(CaseBriefs, LeaveEverythingElseToTheFullReader) {
    EXPECT_FALSE(readCaseBrief(file_, "plan")) << "no file";
    write({});
    EXPECT_TRUE(readCaseBrief(file_, "plan"));
    EXPECT_FALSE(readCaseBrief(file_, "another plan"));
    const std::string text = test::contentOf(file_);
    for (std::size_t size = 0; size < text.size(); ++size) {
        test::putContent(file_, text.substr(0, size));
        EXPECT_FALSE(readCaseBrief(file_, "plan")) << "of " << size << " bytes";
    }
    test::putContent(file_, text + std::string(20000, ' ') + "\n}\n");
    EXPECT_FALSE(readCaseBrief(file_, "plan")) << "longer than it needs to be";
    std::filesystem::remove(file_);
    ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
    EXPECT_FALSE(readCaseBrief(file_, "plan")) << "a pipe is not waited for";
}

}  // namespace
}  // namespace keyblock
