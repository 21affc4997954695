// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every case of the verification and every row of the published tables as a test.
#include "solver/verify/verify.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <iterator>

namespace keyblock {
namespace {

/// A test's name may hold letters, digits and `_` only.
std::string testName(const std::string& name) {
    std::string plain;
    for (const char c : name) plain += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return plain;
}

class VerificationCase : public testing::TestWithParam<std::size_t> {};

TEST_P(VerificationCase, MeetsItsNumbers) {
    const std::vector<CaseResult> results = cases()[GetParam()].run();
    ASSERT_FALSE(results.empty());
    for (const CaseResult& r : results)
        EXPECT_TRUE(r.passed) << r.quantity << ": measured " << r.measured << ", expected " << r.expected
                              << ", tolerance " << r.tolerance << (r.relative ? " relative" : "");
}

INSTANTIATE_TEST_SUITE_P(All, VerificationCase, testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& one) { return testName(cases()[one.param].name); });

TEST(Help, NamesEveryCase) {
    std::ifstream file(std::string(KEYBLOCK_SOURCE_DIR) + "/resources/help/verification.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const Case& each : cases())
        EXPECT_NE(page.find("`" + each.name + "` | " + each.description), std::string::npos) << each.name;
}

TEST(Paper, TablesMeetTheReference) {
    const std::vector<PaperTable> tables = paperTables();
    ASSERT_EQ(tables.size(), 13u);
    for (const PaperTable& table : tables) {
        ASSERT_FALSE(table.rows.empty()) << table.title;
        for (const PaperRow& row : table.rows)
            EXPECT_TRUE(row.passed) << table.title << ", " << row.quantity << ": reference "
                                    << row.reference.value_or(0.0) << ", measured " << row.keyblock << " " << row.unit;
    }
}

}  // namespace
}  // namespace keyblock
