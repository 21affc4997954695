// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trades of a block that slides down a slope: its displacement has a closed form, and a
// trade that was stopped continues with the runs that it has made.
#include "solver/trade/trade.h"

#include "solver/trade/trade_errors.h"
#include "solver/trade/trade_folder.h"
#include "solver/run/run.h"
#include "solver/run/write_error.h"
#include "solver/verify/scenes.h"
#include "tests/scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

Scene slidingScene() {
    Scene scene = inclineScene(30.0, 20.0, 0.02);
    scene.analysis.tolerance = 1e-4;
    scene.quantities = {"last slider.u", "stands"};
    return scene;
}

TradeSettings settingsWith(Control& control, int& runs, int most = 1000) {
    TradeSettings settings;
    settings.run = [&control, &runs, most](const Scene& scene, const SceneCut& cut, int threads, const std::string&,
                                           Sink& sink) {
        if (++runs > most) control.stop = true;
        run(scene, sink, control, {threads, &cut});
    };
    return settings;
}

TEST(Trade, ComparesEverySettingWithTheFinest) {
    Control control;
    int runs = 0;
    Trade trade;
    ASSERT_TRUE(measureTrade(slidingScene(), settingsWith(control, runs), trade));
    EXPECT_EQ(static_cast<int>(trade.points.size()), runs);
    EXPECT_FALSE(trade.proposed);
    EXPECT_EQ(trade.points.front().axis, ownPoint);
    ASSERT_EQ(trade.points[trade.reference].axis, referencePoint);
    // g·(sin 30° − cos 30°·tan 20°)·t²/2
    const double exact = 0.5 * gravity * (0.5 - std::cos(30.0 * degree) * std::tan(20.0 * degree)) * 0.02 * 0.02;
    EXPECT_NEAR(trade.points[trade.reference].values[0].value.value(), exact, 1e-2 * exact);
    for (std::size_t i = 0; i < trade.points.size(); ++i)
        EXPECT_LT(largestError(trade.points[i], trade.points[trade.reference], trade.quantities), 0.5)
            << nameOf(trade.points[i]);
    EXPECT_GE(recommendedPoint(trade, 0.5), 0);
}

TEST(Trade, LeavesOutWhatTheBudgetDoesNotAllow) {
    Control control;
    int runs = 0;
    TradeSettings settings = settingsWith(control, runs);
    settings.budget = 1e-9;
    Trade trade;
    ASSERT_TRUE(measureTrade(slidingScene(), settings, trade));
    EXPECT_EQ(runs, 1);  // the scene's own settings are always measured
    EXPECT_EQ(trade.reference, 0);
    EXPECT_GT(trade.leftOut.size(), 5u);
}

TEST(Trade, ContinuesWhereItWasStopped) {
    const test::ScratchFolder scratch;
    const Scene scene = slidingScene();
    int runs = 0;
    const auto measured = [&](int most, Trade& trade) {
        Control control;
        runs = 0;
        TradeFolder folder(scratch.path() / "trade", scene);
        TradeSettings settings = settingsWith(control, runs, most);
        trade.quantities = folder.quantities();
        settings.known = [&](const TradeSetting& setting) { return folder.known(setting); };
        settings.measured = [&](const TradePoint& point) { folder.keep(point, trade.quantities); };
        const bool whole = measureTrade(scene, settings, trade);
        folder.writeTables(trade, scene);
        return whole;
    };
    Trade first, second;
    EXPECT_FALSE(measured(4, first));
    EXPECT_TRUE(first.interrupted);
    EXPECT_EQ(first.points.size(), 4u);
    EXPECT_NE(test::contentOf(scratch.path() / "trade/trade.md").find("interrupted"), std::string::npos);
    ASSERT_TRUE(measured(1000, second));
    EXPECT_EQ(static_cast<std::size_t>(runs) + 4, second.points.size());
    EXPECT_EQ(second.points[3].seconds, first.points[3].seconds);
    EXPECT_EQ(second.points[3].values[0].value, first.points[3].values[0].value);
    const std::string table = test::contentOf(scratch.path() / "trade/trade.csv");
    EXPECT_TRUE(
        table.starts_with("axis,setting,quantity,value,error,wall_s,steps,passes,factorizations,unknowns,on_front,"
                          "preset,order,expected_error,solves,memory_MB,blocks_moved,scatter\n"));
}

TEST(Trade, ProposesQuantitiesForASceneWithoutAny) {
    Scene scene = slidingScene();
    scene.quantities.clear();
    Control control;
    int runs = 0;
    TradeSettings settings = settingsWith(control, runs);
    settings.budget = 1e-9;
    Trade trade;
    ASSERT_TRUE(measureTrade(scene, settings, trade));
    EXPECT_TRUE(trade.proposed);
    EXPECT_EQ(trade.quantities, (std::vector<std::string>{"stands", "energy_error", "last slider.u"}));
}

TEST(TradeFolder, KeepsToTradesOfItsOwnScene) {
    const test::ScratchFolder scratch;
    const auto folder = scratch.path() / "trade";
    TradePoint point;
    point.axis = "tolerance";
    point.values = {{1.0, "", {}}};
    TradeFolder(folder, slidingScene()).keep(point, {"stands"});
    EXPECT_EQ(TradeFolder(folder, slidingScene()).knownPoints(), 1u);
    Scene other = slidingScene();
    other.title = "another";
    EXPECT_THROW(TradeFolder(folder, other), CannotWrite);
    test::putContent(folder / "points.json", "{");
    EXPECT_THROW(TradeFolder(folder, slidingScene()), CannotWrite);
    std::filesystem::create_directory(scratch.path() / "mine");
    test::putContent(scratch.path() / "mine/notes.txt", "");
    EXPECT_THROW(TradeFolder(scratch.path() / "mine", slidingScene()), CannotWrite);
}

}  // namespace
}  // namespace keyblock
