// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/csv.h"

#include "solver/files/csv/csv_rows.h"

#include <gtest/gtest.h>

#include <sstream>

namespace keyblock {
namespace {

std::string written(const std::string& name) {
    std::ostringstream out;
    CsvWriter(out).text(name).endRow();
    return out.str();
}

TEST(CsvWriter, FormulasBecomeText) {
    EXPECT_EQ(written("=1+1"), "'=1+1\n");
    EXPECT_EQ(written("+A1"), "'+A1\n");
    EXPECT_EQ(written("-2+cmd"), "'-2+cmd\n");
    EXPECT_EQ(written("@SUM(A1)"), "'@SUM(A1)\n");
    EXPECT_EQ(written("\t=1"), "'\t=1\n");
    EXPECT_EQ(written("=HYPERLINK(\"a\",\"b\")"), "\"'=HYPERLINK(\"\"a\"\",\"\"b\"\")\"\n");
}

TEST(CsvWriter, NumbersAndOtherNamesStay) {
    for (const std::string name : {"-5", "+2.5", "-1e-3", "block 3", "a=b", "R1", "", "'quoted'", "’"})
        EXPECT_EQ(written(name), name + "\n");
    std::ostringstream out;
    CsvWriter(out).number(-0.25).integer(-3).index(-1).endRow();
    EXPECT_EQ(out.str(), "-0.25,-3,\n");
}

TEST(CsvWriter, NamesAreReadBackAsTheyWere) {
    for (const std::string name : {"=1+1", "'=1+1", "''-x", "'plain", "-5", "+a, \"b\"", "@x", "-"}) {
        const CsvRows read = readCsvRows("name\n" + written(name));
        ASSERT_EQ(read.rows.size(), 2U) << name;
        EXPECT_EQ(read.rows[1].front().text, name);
    }
}

}  // namespace
}  // namespace keyblock
