// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records come out as their maker meant them or not at all; the files of
// tests/data/broken try what spreadsheets do to them, this the rest.
#include "solver/files/scene/record_file.h"

#include "solver/scene/number_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <string>

namespace keyblock {
namespace {

void expectFault(const std::string& text, const std::string& part) {
    const RecordReading reading = readRecordText(text);
    ASSERT_FALSE(reading.faults.empty()) << text;
    EXPECT_NE((reading.faults[0].message + " " + reading.faults[0].remedy).find(part), std::string::npos)
        << reading.faults[0].message;
    EXPECT_TRUE(reading.record.empty());
}

TEST(RecordFile, TakesWhatMeansTheSameEverywhere) {
    const Table expected{{0.0, 0.0}, {0.01, -0.15}, {0.02, 1500.0}};
    for (const std::string text :
         {"time_s,a\n0,0\n0.01,-0.15\n0.02,1500\n", "time_s,a\r\n0,0\r\n1e-2,-15E-2\r\n0.020,1.5e+3",
          "\xEF\xBB\xBF time_s , a \n 0 , 0\n.01,-.15\n+0.02,+1500 \n\n  \n"}) {
        const RecordReading reading = readRecordText(text);
        EXPECT_TRUE(reading.faults.empty()) << reading.faults[0].message;
        EXPECT_EQ(reading.record, expected) << text;
    }
}

TEST(RecordFile, RefusesWhatCouldMeanSomethingElse) {
    expectFault("time_s;a\n0;0\n", "not semicolons");
    expectFault("time_s,a\n0,0\n0,01,0,5\n", "decimal points");
    expectFault("time_s,a\n0,0\n1.000,5,3\n", "3 columns");
    expectFault("time_s,a\n0\n", "1 columns");
    expectFault("time_s,a\n0\t0\n", "has a tab");
    expectFault("time_s,a\n0,1_000\n", "not a number");
    expectFault("time_s,a\n0,0x1p3\n", "not a number");
    expectFault("time_s,a\n0,1.0D-3\n", "not a number");
    expectFault("time_s,a\n0,--1\n", "not a number");
    expectFault("time_s,a\n0,+-1\n", "not a number");
    expectFault("time_s,a\n0,\n", "not a number");
    expectFault("time_s,a\n0,inf\n1,0\n", "not finite");
    expectFault("time_s,a\n0,1e999\n1,0\n", "not a number");
    expectFault("time_s,a\n0,0\n0,1\n", "does not increase");
    expectFault("# a comment\ntime_s,a\n0,0\n", "header");
    expectFault("a,time_s\n0,0\n1,1\n", "header");
    expectFault("time_s,a,v\n0,0,0\n1,1,1\n", "header");
}

TEST(RecordFile, TellsTenCellsAndNoMore) {
    std::string text = "time_s,a\n";
    for (int i = 0; i < 100; ++i) text += std::to_string(i) + ",x\n";
    const RecordReading reading = readRecordText(text);
    EXPECT_EQ(reading.faults.size(), 10u);
    EXPECT_NE(reading.faults[9].message.find("row 11, column 2"), std::string::npos) << reading.faults[9].message;
}

TEST(RecordFile, FilesThatCannotBeReadAreFaults) {
    EXPECT_NE(readRecordFile("no/such/file.csv").faults.at(0).message.find("cannot be opened"), std::string::npos);
    EXPECT_NE(readRecordFile(KEYBLOCK_TEST_DATA_DIR).faults.at(0).message.find("folder"), std::string::npos);
}

/// What a German locale would do to streams, without any being installed.
class DecimalComma : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

const Table halves{{0.5, -0.5}, {1234567.25, 0.25}};

TEST(DecimalCommas, OfStreamsChangeNothing) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    std::ostringstream works;
    works << 0.5;
    const RecordReading reading = readRecordText("time_s,a\n0.5,-0.5\n1234567.25,0.25\n");
    const std::string number = shortest(1234567.25);
    std::locale::global(before);
    EXPECT_EQ(works.str(), "0,5");
    EXPECT_EQ(reading.record, halves);
    EXPECT_EQ(number, "1234567.25");
}

#ifdef KEYBLOCK_LOCALES
TEST(DecimalCommas, OfTheCLibraryChangeNothing) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    setenv("LOCPATH", KEYBLOCK_LOCALES, 1);
    ASSERT_TRUE(std::setlocale(LC_ALL, "de_DE.UTF-8"));
    const RecordReading reading = readRecordText("time_s,a\n0.5,-0.5\n1234567.25,0.25\n");
    const std::string number = shortest(1234567.25);
    std::setlocale(LC_ALL, before.c_str());
    EXPECT_EQ(reading.record, halves);
    EXPECT_EQ(number, "1234567.25");
}
#endif

}  // namespace
}  // namespace keyblock
