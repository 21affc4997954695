// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of a case depend on the study and on its number, and on nothing else.
#include "solver/study/case_plan.h"

#include "solver/study/case_table.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <set>

namespace keyblock {
namespace {

StudyParameter uniformParameter(const std::string& name, double least, double most) {
    StudyParameter parameter;
    parameter.name = name;
    parameter.path = "a." + name;
    parameter.distribution.emplace();
    parameter.distribution->least = least;
    parameter.distribution->most = most;
    return parameter;
}

StudyParameter listParameter(const std::string& name, std::vector<std::string> values) {
    StudyParameter parameter;
    parameter.name = name;
    parameter.path = "b." + name;
    parameter.values = std::move(values);
    return parameter;
}

StudyParameter seedParameter() {
    StudyParameter parameter;
    parameter.name = "joints";
    parameter.path = "joint_sets[0].seed";
    parameter.also = {"joint_sets[1].seed"};
    parameter.distribution.emplace();
    parameter.distribution->kind = DistributionKind::Seed;
    return parameter;
}

Study studyOf(PlanKind kind, int cases, std::vector<StudyParameter> parameters) {
    Study study;
    study.plan.kind = kind;
    if (kind != PlanKind::FullFactorial) study.plan.cases = cases;
    study.parameters = std::move(parameters);
    return study;
}

TEST(CasePlan, MonteCarloCasesKeepTheirValuesInALargerPlanWithMoreParameters) {
    const Study small = studyOf(PlanKind::MonteCarlo, 10, {uniformParameter("x", 0, 1), seedParameter()});
    const Study large = studyOf(PlanKind::MonteCarlo, 1000,
                                {uniformParameter("y", 5, 6), uniformParameter("x", 0, 1), seedParameter()});
    const CasePlan a(small), b(large);
    std::set<std::string> seen;
    for (long number = 1; number <= 10; ++number) {
        EXPECT_EQ(a.row(number)[0], b.row(number)[1]);
        EXPECT_EQ(a.row(number)[1], b.row(number)[2]);
        seen.insert(a.row(number)[0]);
    }
    EXPECT_EQ(seen.size(), 10u);
    Study other = small;
    other.plan.seed = 2;
    EXPECT_NE(CasePlan(other).row(1), a.row(1));
}

TEST(CasePlan, LatinHypercubeUsesEachPartOnce) {
    const Study study = studyOf(
        PlanKind::LatinHypercube, 200,
        {uniformParameter("x", 0, 200), uniformParameter("y", 0, 200), listParameter("kind", {"1", "2", "3", "4"})});
    const CasePlan plan(study);
    std::set<int> x, y;
    int ones = 0, together = 0;
    for (long number = 1; number <= 200; ++number) {
        const std::vector<std::string> row = plan.row(number);
        const int partOfX = static_cast<int>(std::stod(row[0])), partOfY = static_cast<int>(std::stod(row[1]));
        x.insert(partOfX);
        y.insert(partOfY);
        together += partOfX == partOfY;
        ones += row[2] == "1";
    }
    EXPECT_EQ(x.size(), 200u);
    EXPECT_EQ(y.size(), 200u);
    EXPECT_EQ(ones, 50);  // equal shares of a list, too
    EXPECT_LT(together, 8);  // one on average: the two orders are independent
}

TEST(CasePlan, FullFactorialHasEveryCombinationOnce) {
    StudyParameter range;
    range.name = range.path = "r";
    range.range = StudyRange{0.1, 0.3, 3};
    const Study study = studyOf(PlanKind::FullFactorial, 0, {listParameter("k", {"\"a\"", "true"}), range});
    const CasePlan plan(study);
    ASSERT_EQ(plan.cases(), 6);
    std::set<std::vector<std::string>> rows;
    for (long number = 1; number <= 6; ++number) rows.insert(plan.row(number));
    EXPECT_EQ(rows.size(), 6u);
    EXPECT_EQ(plan.row(1), (std::vector<std::string>{"a", "0.1"}));
    EXPECT_EQ(plan.row(6), (std::vector<std::string>{"true", "0.3"}));
    EXPECT_EQ(overridesOf(study, plan.row(1)), (std::vector<std::string>{"b.k=\"a\"", "r=0.1"}));
}

TEST(CasePlan, SeedsOfFurtherPathsDiffer) {
    const Study study = studyOf(PlanKind::MonteCarlo, 3, {seedParameter()});
    const std::vector<std::string> overrides = overridesOf(study, {"17"});
    EXPECT_EQ(overrides, (std::vector<std::string>{"joint_sets[0].seed=17", "joint_sets[1].seed=18"}));
}

TEST(CaseTable, EveryRowIsFoundAndNoOther) {
    const test::ScratchFolder folder;
    const Study study = studyOf(
        PlanKind::MonteCarlo, 1234,
        {listParameter("with \"quotes\", and commas", {"\"a, \\\"b\\\"\"", "2"}), uniformParameter("x", 0, 1)});
    const CasePlan plan(study);
    const std::filesystem::path file = folder.path() / "cases.csv";
    test::putContent(file, caseTable(study, plan));
    for (long number = 1; number <= 1234; ++number) ASSERT_EQ(readCaseRow(file, number, 2), plan.row(number)) << number;
    EXPECT_ANY_THROW(readCaseRow(file, 1235, 2));
    EXPECT_ANY_THROW(readCaseRow(file, 0, 2));
    EXPECT_ANY_THROW(readCaseRow(file, 7, 3));
}

}  // namespace
}  // namespace keyblock
