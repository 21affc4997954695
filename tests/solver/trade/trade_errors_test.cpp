// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Errors, orders and the front of trades whose numbers are given, so that each can be
// worked out by hand.
#include "solver/trade/trade_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

TradePoint point(const std::string& axis, double size, double seconds, double value) {
    TradePoint result;
    result.axis = axis;
    result.setting = std::to_string(size);
    result.size = size;
    result.seconds = seconds;
    result.values = {{value, "", {}}};
    return result;
}

/// A quantity of 10 with an error of the square of the size, and the scene's own settings at size 1.
Trade squareTrade() {
    Trade trade;
    trade.quantities = {"last crown.u"};
    trade.points = {point(ownPoint, 0.0, 4.0, 11.0), point(referencePoint, 0.0, 50.0, 10.0),
                    point("time_step", 2.0, 2.0, 14.0), point("time_step", 0.5, 8.0, 10.25)};
    trade.reference = 1;
    trade.ownSizes["time_step"] = 1.0;
    return trade;
}

TEST(TradeErrors, AreRelativeToTheReference) {
    const Trade trade = squareTrade();
    EXPECT_DOUBLE_EQ(errorOf(trade.points[0], trade.points[1], trade.quantities, 0).value(), 0.1);
    EXPECT_DOUBLE_EQ(largestError(trade.points[2], trade.points[1], trade.quantities), 0.4);
    const TradePoint zero = point(ownPoint, 0.0, 1.0, 0.0), other = point(ownPoint, 0.0, 1.0, 0.02);
    EXPECT_DOUBLE_EQ(errorOf(other, zero, trade.quantities, 0).value(), 0.02);
}

TEST(TradeErrors, AreInfiniteWhereARunHasNoResult) {
    Trade trade = squareTrade();
    trade.points[2].values[0].value.reset();
    EXPECT_TRUE(std::isinf(largestError(trade.points[2], trade.points[1], trade.quantities)));
    trade.points[3].failure = "stage 'a' ended as failed";
    EXPECT_TRUE(std::isinf(largestError(trade.points[3], trade.points[1], trade.quantities)));
    EXPECT_FALSE(isOnFront(trade, 3));
}

TEST(TradeErrors, CountEventsInAnotherOrder) {
    TradePoint a = point(ownPoint, 0.0, 1.0, 0.0), b = a;
    a.values = {{std::nullopt, "", {"R1", "R2", "R3", "R4"}}};
    b.values = {{std::nullopt, "", {"R2", "R1", "R3", "R4"}}};
    EXPECT_DOUBLE_EQ(errorOf(a, b, {"order debonding"}, 0).value(), 0.25);
    EXPECT_DOUBLE_EQ(errorOf(a, a, {"order debonding"}, 0).value(), 0.0);
    b.values = {{std::nullopt, "no debonding happened", {}}};
    EXPECT_DOUBLE_EQ(errorOf(a, b, {"order debonding"}, 0).value(), 1.0);
}

TEST(TradeErrors, DoNotIncludeTheEnergyError) {
    const TradePoint a = point(ownPoint, 0.0, 1.0, 1e-5), b = point(ownPoint, 0.0, 1.0, 1e-3);
    EXPECT_FALSE(errorOf(a, b, {"energy_error"}, 0));
    EXPECT_EQ(largestError(a, b, {"energy_error"}), 0.0);
}

TEST(ConvergenceOrder, OfAnErrorThatFallsWithTheSquareIsTwo) {
    const ConvergenceOrder order = convergenceOrder(squareTrade(), "time_step", 0);
    ASSERT_EQ(order.kind, ConvergenceOrder::Kind::Regular);
    EXPECT_NEAR(order.order, 2.0, 1e-12);
    EXPECT_NEAR(order.limit, 10.0, 1e-12);
}

TEST(ConvergenceOrder, IsNotGivenWhereValuesGoBackAndForth) {
    Trade trade = squareTrade();
    trade.points[3].values[0].value = 11.5;
    EXPECT_EQ(convergenceOrder(trade, "time_step", 0).kind, ConvergenceOrder::Kind::Irregular);
    for (TradePoint& p : trade.points) p.values[0].value = 10.0;
    EXPECT_EQ(convergenceOrder(trade, "time_step", 0).kind, ConvergenceOrder::Kind::NoEffect);
    EXPECT_EQ(convergenceOrder(trade, "penalty_ratio", 0).kind, ConvergenceOrder::Kind::Unknown);
}

/// The scene's own settings give 11, half the step 11.5, twice the step 14: the reference is known to ±3 of 10.
TEST(TradeErrors, AreKnownToWithinTheScatterOfIrregularQuantities) {
    Trade trade = squareTrade();
    EXPECT_EQ(scatterOf(trade, 0), 0.0);
    trade.points[3].values[0].value = 11.5;
    EXPECT_NEAR(scatterOf(trade, 0), 0.3, 1e-12);
    EXPECT_EQ(sentenceOn(trade, 0), "own settings: 4 s, last crown.u +10 % ± 30 % (±: not regular)");
    TradePoint finer = point("tolerance", 1e-5, 5.0, 11.0);  // two axes: their scatters add up
    trade.points.push_back(finer);
    finer.size = 1e-6, finer.values[0].value = 10.9;
    trade.points.push_back(finer);
    trade.ownSizes["tolerance"] = 1e-4;
    EXPECT_NEAR(scatterOf(trade, 0), 0.3 + 0.01, 1e-12);
    trade.points[1].values[0].value = 0.0;  // absolute
    EXPECT_NEAR(scatterOf(trade, 0), 3.0 + 0.1, 1e-12);
    trade.quantities = {"stands"};
    EXPECT_EQ(scatterOf(trade, 0), 0.0);
}

/// Coarse settings may miss an event; the finest three decide.
TEST(ConvergenceOrder, DoesNotNeedValuesOfCoarseSettings) {
    Trade trade = squareTrade();
    trade.points.push_back(point("time_step", 4.0, 1.0, 0.0));
    trade.points.back().values[0].value.reset();
    EXPECT_EQ(convergenceOrder(trade, "time_step", 0).kind, ConvergenceOrder::Kind::Regular);
    trade.points[2].values[0].value.reset();
    EXPECT_EQ(convergenceOrder(trade, "time_step", 0).kind, ConvergenceOrder::Kind::Unknown);
}

TEST(TradeFront, HasThePointsThatNoOtherBeats) {
    Trade trade = squareTrade();
    trade.points.push_back(
        point("tolerance", 1e-3, 5.0, 12.0));  // slower and farther off than the scene's own settings
    EXPECT_TRUE(isOnFront(trade, 0));
    EXPECT_TRUE(isOnFront(trade, 2));
    EXPECT_TRUE(isOnFront(trade, 3));
    EXPECT_FALSE(isOnFront(trade, 4));
}

TEST(TradeFront, RecommendsTheFastestThatIsCloseEnough) {
    const Trade trade = squareTrade();
    EXPECT_EQ(recommendedPoint(trade, 0.03), 3);
    EXPECT_EQ(recommendedPoint(trade, 0.1), 0);
    EXPECT_EQ(recommendedPoint(trade, 0.5), 2);
    EXPECT_EQ(sentenceOn(trade, 2), "time_step 2.000000: 2 × faster than the scene's own settings, last crown.u +40 %");
}

/// Without a finer run the error of the scene's own settings is unknown; coarser ones can still be compared with them.
TEST(TradeFront, DoesNotRecommendTheReference) {
    Trade trade = squareTrade();
    trade.points.resize(1);
    trade.reference = 0;
    EXPECT_EQ(recommendedPoint(trade, 0.03), -1);
    EXPECT_EQ(recommendedPreset(trade, 0.03), -1);
    EXPECT_NE(withoutRecommendation(trade, 0.03).find("nothing finer"), std::string::npos);
    trade.points.push_back(point("time_step", 2.0, 2.0, 11.1));
    EXPECT_EQ(recommendedPoint(trade, 0.03), 1);
    const Trade square = squareTrade();
    EXPECT_EQ(recommendedPoint(square, 0.001), -1);
    EXPECT_NE(withoutRecommendation(square, 0.001).find("within 0.1 % of the finest run"), std::string::npos);
}

/// A preset that takes `seconds` and `factorizations`, with an error of `error` in a quantity of 10.
TradePoint presetPoint(const std::string& name, double seconds, long factorizations, double error) {
    TradePoint result = point(presetAxisName, 0.0, seconds, 10.0 * (1.0 + error));
    result.setting = result.preset = name;
    result.work.fullFactorizations = result.work.factorizations = factorizations;
    return result;
}

TEST(TradePresets, RecommendTheFastestThatIsCheaperAndCloseEnough) {
    Trade trade = squareTrade();
    trade.points = {presetPoint("engineering", 4.0, 100, 0.01), point(referencePoint, 0.0, 50.0, 10.0),
                    presetPoint("draft", 2.0, 50, 0.02), presetPoint("sketch", 1.0, 25, 0.2),
                    presetPoint("reference", 3.0, 400, 0.0)};
    trade.points.front().axis = ownPoint;
    EXPECT_EQ(recommendedPreset(trade, 0.03), 2);
    EXPECT_EQ(recommendedPreset(trade, 0.3), 3);
    EXPECT_EQ(recommendedPreset(trade, 0.015), 0) << "reference was faster by chance: it did more work";
    EXPECT_EQ(recommendedPreset(trade, 0.001), 4);
    EXPECT_NE(sentenceOn(trade, 2).find("draft: 2 × faster than engineering"), std::string::npos);
}

}  // namespace
}  // namespace keyblock
