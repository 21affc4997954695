// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measured curves as laboratories of many countries write them down are the same
// numbers in SI.
#include "solver/files/scene/reference_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace keyblock {
namespace {

using Values = std::vector<double>;

ReferenceTable tableOf(const std::string& text) {
    const ReferenceReading reading = readReferenceTable(text, "lab.csv");
    EXPECT_FALSE(hasErrors(reading.problems)) << text << "\n" << oneLine(reading.problems.front());
    return reading.table;
}

std::string errorOf(const std::string& text) {
    const ReferenceReading reading = readReferenceTable(text, "lab.csv");
    for (const Problem& problem : reading.problems)
        if (problem.severity == Severity::Error) return oneLine(problem);
    return "";
}

TEST(ReferenceFile, SaysTheSameInEveryDress) {
    for (const std::string text : {"opening_mm,load_kN\n0.5,20\n1,-40\n", "load_N;opening_m\n20000;0,0005\n-40000;0,001\n",
                                   "Opening [cm]\tLoad (MN)\n0.05\t0.02\n0.1\t-0.04\n",
                                   "\xEF\xBB\xBFopening mm,load kn\r\n\"0,5\",\"20\"\r\n\"1\",\"-40\"\r\n"}) {
        const ReferenceTable table = tableOf(text);
        ASSERT_EQ(table.columns.size(), 2U);
        EXPECT_EQ(table.name, "lab");
        for (const ReferenceColumn& column : table.columns) {
            const bool force = column.measure == Measure::Force;
            EXPECT_EQ(plainName(column.name), force ? "load" : "opening");
            EXPECT_EQ(column.values, force ? Values({2e4, -4e4}) : Values({5e-4, 1e-3})) << text;
        }
    }
}

TEST(ReferenceFile, UnitsAreKnownByTheirMeasure) {
    const ReferenceTable table = tableOf("t [ms],moment_kNm,work_kJ,strain [%],strain (mm/m),ratio,Weg (µm)\n"
                                         "2,3,4,5,6,7,8\n");
    const Values si{2e-3, 3e3, 4e3, 0.05, 6e-3, 7.0, 8e-6};
    const Measure measures[]{Measure::Time,   Measure::Moment, Measure::Energy, Measure::Number,
                             Measure::Number, Measure::Number, Measure::Length};
    ASSERT_EQ(table.columns.size(), si.size());
    for (std::size_t i = 0; i < si.size(); ++i) {
        EXPECT_EQ(table.columns[i].values[0], si[i]) << table.columns[i].title;
        EXPECT_EQ(table.columns[i].measure, measures[i]) << table.columns[i].title;
    }
}

TEST(ReferenceFile, MissingValuesAndWordsAreLeftOut) {
    const ReferenceReading reading = readReferenceTable("x_mm,remark,load_kN\n1,ok,\n2,,nan\n3,late,4\n", "lab.csv");
    ASSERT_EQ(reading.table.columns.size(), 2U);
    EXPECT_TRUE(std::isnan(reading.table.columns[1].values[0]));
    EXPECT_TRUE(std::isnan(reading.table.columns[1].values[1]));
    EXPECT_EQ(reading.table.columns[1].values[2], 4e3);
    ASSERT_EQ(reading.problems.size(), 1U);
    EXPECT_EQ(reading.problems[0].severity, Severity::Warning);
    EXPECT_NE(reading.problems[0].message.find("column 2 ('remark')"), std::string::npos);
}

TEST(ReferenceFile, TellsWhereItIsWrong) {
    const auto expect = [](const std::string& text, const std::string& place, const std::string& part) {
        const std::string error = errorOf(text);
        EXPECT_NE(error.find("lab.csv"), std::string::npos) << error;
        EXPECT_NE(error.find(place), std::string::npos) << error;
        EXPECT_NE(error.find(part), std::string::npos) << error;
    };
    expect("", "", "empty");
    expect("x_mm,load_kN\n", "", "no rows");
    expect("x_mm,load_kN\n1,2\n3,many\n", "3", "column 2 ('load_kN') holds 'many'");
    expect("x_mm,load_kN\n1,2\n3\n", "3", "1 cells, and the header 2");
    expect("x_mm,load [kip]\n1,2\n", "1", "its unit 'kip' is not one of s, ms");
    expect("x_mm;load_kN\n1,5;2\n2.5;3\n", "3", "decimal point");
    expect("x_mm,remark\n1,good\n", "1", "two columns");
    expect("x_mm,[kN]\n1,2\n", "1", "no name");
}

TEST(ReferenceFile, WhatIsWrittenReadsBack) {
    ReferenceTable table = tableOf("stage,time_s,gap_mm,load (kN),use\npull,0,1,0.1,3\npull,0.1,,7,4\n");
    EXPECT_EQ(table.stages, (std::vector<std::string>{"pull", "pull"}));
    std::ostringstream out;
    writeReferenceTable(table, out);
    EXPECT_EQ(out.str().rfind("stage,time_s,gap_m,load_N,use\n", 0), 0U) << out.str();
    const ReferenceTable again = tableOf(out.str());
    ASSERT_EQ(again.columns.size(), table.columns.size());
    EXPECT_EQ(again.stages, table.stages);
    EXPECT_EQ(again.columns[2].values, table.columns[2].values);
    EXPECT_EQ(again.columns[1].values[0], 1e-3);
    EXPECT_TRUE(std::isnan(again.columns[1].values[1]));
}

}  // namespace
}  // namespace keyblock
