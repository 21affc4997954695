// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantities are read from rows whose values name their own row and column, so a
// wrong column or a wrong row shows.
#include "solver/results/quantity.h"

#include "solver/results/history.h"
#include "tests/solver/results/sample_run.h"

#include <gtest/gtest.h>

#include <limits>

namespace keyblock {
namespace {

double measured(const std::string& text) {
    const Measurement measurement = measure(text, test::sampleScene(), test::sampleResults());
    EXPECT_TRUE(measurement.value) << text << ": " << measurement.problem;
    return measurement.value.value_or(std::numeric_limits<double>::quiet_NaN());
}

TEST(HistoryColumns, AreNamedAsTheTablesPrintThem) {
    const HistoryColumns columns = historyColumns(test::sampleScene());
    ASSERT_EQ(columns.names.size(), 4 + boltQuantityRows.size());
    EXPECT_EQ(columns.monitorValues, 4);
    EXPECT_EQ(columns.names[0], "crown_ux_m");
    EXPECT_EQ(columns.names[1], "crown_uy_m");
    EXPECT_EQ(columns.names[2], "opening_m");
    EXPECT_EQ(columns.names[3], "joint_force_N");
    EXPECT_EQ(columns.names[4], "B, \"1\".axial_force");
    EXPECT_EQ(columns.names[11], "B, \"1\".strain");
}

TEST(HistoryColumns, CarryTheUnitOfABoltsQuantity) {
    Scene scene = test::sampleScene();
    const auto lastName = [&](BoltQuantity quantity) {
        scene.monitors[2].quantity = quantity;
        return historyColumns(scene).names[3];
    };
    EXPECT_EQ(lastName(BoltQuantity::Moment), "joint_force_Nm");
    EXPECT_EQ(lastName(BoltQuantity::Slip), "joint_force_m");
    EXPECT_EQ(lastName(BoltQuantity::DebondedLength), "joint_force_m");
    EXPECT_EQ(lastName(BoltQuantity::PlateForce), "joint_force_N");
    EXPECT_EQ(lastName(BoltQuantity::Strain), "joint_force");
}

TEST(Measure, ReducesAColumn) {
    EXPECT_EQ(measured("max opening"), 302.0);
    EXPECT_EQ(measured("min crown.uy"), 1.0);
    EXPECT_EQ(measured("last joint force"), 93.0);
    EXPECT_EQ(measured("max B, \"1\".axial_force"), 304.0);
    EXPECT_EQ(measured("last B, \"1\".strain"), 101.0);
}

TEST(Measure, TakesTheRowJustBeforeTheFirstEventOfAKind) {
    EXPECT_EQ(measured("first debonding opening"), 102.0);
    // The joint opens at the same time, after the debonding and the row that follows it.
    EXPECT_EQ(measured("first joint-open opening"), 302.0);
}

TEST(Measure, EventsOfOneReleaseShareTheRowBefore) {
    Results results = test::sampleResults();
    results.events[1].historyRow = results.events[0].historyRow;
    EXPECT_EQ(measure("first joint-open opening", test::sampleScene(), results).value, 102.0);
}

TEST(Measure, SaysWhyThereIsNoNumber) {
    const Scene scene = test::sampleScene();
    Results results = test::sampleResults();
    EXPECT_NE(measure("first collapse opening", scene, results).problem.find("no collapse"), std::string::npos);
    EXPECT_NE(measure("max nothing", scene, results).problem.find("is not the name of a monitor"), std::string::npos);
    results.events[0].historyRow = -1;
    EXPECT_FALSE(measure("first debonding opening", scene, results).value);
    results.events[0].historyRow = 1;
    results.history.clear();
    EXPECT_FALSE(measure("max opening", scene, results).value);
    EXPECT_FALSE(measure("first debonding opening", scene, results).value);
}

TEST(Measure, TakesTheMagnitudeOfADisplacementRowByRow) {
    Scene scene = test::sampleScene();
    Results results = test::sampleResults();
    for (HistoryRow& row : results.history) row.values[0] = row.values[1] = 0.0;
    results.history[1].values[0] = -3.0;
    results.history[1].values[1] = 4.0;
    results.history[2].values[1] = 4.5;
    EXPECT_EQ(measure("max crown.u", scene, results).value, 5.0);
    EXPECT_EQ(measure("max crown.uy", scene, results).value, 4.5);
}

TEST(Measure, CountsEventsAndListsTheirOrder) {
    const Scene scene = test::sampleScene();
    Results results = test::sampleResults();
    EXPECT_EQ(measure("count debonding", scene, results).value, 1.0);
    EXPECT_EQ(measure("count collapse", scene, results).value, 0.0);
    results.events.push_back(results.events.front());
    results.events.back().node = 0;
    EXPECT_EQ(measure("count debonding", scene, results).value, 2.0);
    EXPECT_EQ(measure("order debonding", scene, results).order, std::vector<std::string>{scene.bolts[0].name});
    results.events.push_back(results.events[1]);
    std::swap(results.events.back().block, results.events.back().otherBlock);
    EXPECT_EQ(measure("order joint-open", scene, results).order.size(), 2u);
    results.events.pop_back();
    EXPECT_EQ(measure("order joint-open", scene, results).order.size(), 1u);
    EXPECT_NE(measure("order collapse", scene, results).problem.find("no collapse"), std::string::npos);
}

TEST(Measure, ReportsStabilityAndTheEnergyBalanceError) {
    const Scene scene = test::sampleScene();
    Results results = test::sampleResults();
    ASSERT_FALSE(results.stages.empty());
    for (StageResult& stage : results.stages) {
        stage.outcome = Outcome::Equilibrium;
        stage.unstable.clear();
        stage.health.balanceError = 1e-6;
    }
    results.stages.front().health.balanceError = -2e-4;
    EXPECT_EQ(measure("energy_error", scene, results).value, 2e-4);
    EXPECT_EQ(measure("stands", scene, results).value, 1.0);
    results.stages.back().outcome = Outcome::Collapse;
    EXPECT_EQ(measure("stands", scene, results).value, 0.0);
    EXPECT_NE(measure("factor_of_safety", scene, results).problem.find("keyblock safety"), std::string::npos);
}

TEST(Measure, NamesTheFirstEventsOfALongOrder) {
    EXPECT_EQ(orderText({"a", "b"}, 2), "a, b");
    EXPECT_EQ(orderText({"a", "b", "c", "d"}, 2), "a, b, and 2 more");
}

TEST(Measure, PassesOverRowsWithoutANumber) {
    const Scene scene = test::sampleScene();
    Results results = test::sampleResults();
    results.history.back().values[2] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(measure("last opening", scene, results).value, 62.0);
}

TEST(Compare, JudgesByRelativeDeviationAndByAbsoluteWhereZeroIsExpected) {
    const Scene scene = test::sampleScene();
    const Results results = test::sampleResults();
    const auto compared = [&](double value, double tolerance) {
        return compare({"max opening", value, tolerance, ""}, {scene, results.history, results.events, {}});
    };
    EXPECT_DOUBLE_EQ(compared(300.0, 0.01).deviation, 2.0 / 300.0);
    EXPECT_TRUE(compared(300.0, 0.01).within);
    EXPECT_FALSE(compared(300.0, 0.005).within);
    EXPECT_DOUBLE_EQ(compared(-302.0, 0.1).deviation, 2.0);
    EXPECT_DOUBLE_EQ(compared(0.0, 400.0).deviation, 302.0);
    EXPECT_TRUE(compared(0.0, 400.0).within);
}

}  // namespace
}  // namespace keyblock
