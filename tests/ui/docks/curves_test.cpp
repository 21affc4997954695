// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dock of curves: a pin is plotted until its cross is clicked, any quantity is
// plotted against any other, and the curves of a second run are added, dashed. The view
// bar shows one kind of arrows at a time.
#include "ui/docks/curve_entries.h"
#include "ui/docks/curves.h"

#include "tests/scratch_folder.h"
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/view_bar.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/runs/pinned_values.h"
#include "ui/runs/time_cursor.h"
#include "ui/runs/view_settings.h"

#include <QComboBox>
#include <QTest>
#include <QToolButton>

#include <algorithm>

namespace keyblock {
namespace {

class CurvesTest : public ::testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }

    void choose(Curves& curves, const char* box, const QString& text) {
        auto* choice = curves.findChild<QComboBox*>(box);
        ASSERT_TRUE(choice);
        const int index = choice->findText(text);
        ASSERT_GE(index, 0) << text.toStdString();
        choice->setCurrentIndex(index);
        Q_EMIT choice->activated(index);
    }

    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
    test::ScratchFolder folder_;
};

Pin sliderPin(const LiveRun& run) {
    SectionRequest request;
    request.frame = 0;
    const auto picture = std::make_shared<const SectionPicture>(sectionPicture(run, request));
    const Point place = *run.scene().monitors.front().point;
    return pinAt(*picture, *PickIndex(picture).at(place, 0.01), place, findQuantity(blockQuantities(), "velocity"),
                 nullptr);
}

TEST_F(CurvesTest, APinIsPlottedUntilItsCrossIsClicked) {
    Themes themes;
    TimeCursor cursor;
    Pins pins(cursor);
    Display display;
    Curves curves(themes, display, cursor, CurveKind::All, &pins);
    auto* view = curves.findChild<ChartView*>("chart");
    auto* choice = curves.findChild<QComboBox*>("curveChoice");
    curves.resize(500, 240);
    curves.show();
    const auto run = test::slidingRun(path("a.kbrun"), 0.3);
    cursor.setRun(run, false);
    EXPECT_FALSE(curves.findChild<QWidget*>("pinLegend")->isVisible());
    ASSERT_TRUE(waitFor([&] { return view->chart().has_value(); }));
    const QString before = choice->currentText();
    pins.add(sliderPin(*run));
    ASSERT_TRUE(waitFor([&] { return choice->currentText().startsWith("Pins: Velocity"); }));
    ASSERT_TRUE(waitFor([&] { return pins.isComplete() && view->chart().has_value(); }));
    ASSERT_TRUE(waitFor([&] {
        const ChartCurve& curve = view->chart()->panels[0].curves[0];
        return curve.name == "1 Block slider" && curve.x.size() == run->frames().size();
    }));
    auto* chip = curves.findChild<QToolButton*>("pin1");
    ASSERT_TRUE(chip && chip->isVisible());
    EXPECT_TRUE(chip->accessibleName().contains("Unpin 1 Block slider"));
    QTest::mouseClick(chip, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return pins.tracks().empty(); }));
    EXPECT_TRUE(waitFor([&] { return choice->currentText() == before; }));
    EXPECT_FALSE(curves.findChild<QWidget*>("pinLegend")->isVisible());
}

TEST_F(CurvesTest, CaptionsFollowTheUnits) {
    Themes themes;
    TimeCursor cursor;
    Display display;
    display.setSystem(UnitSystem::Engineering);
    Curves curves(themes, display, cursor, CurveKind::All, nullptr);
    const auto* view = curves.findChild<ChartView*>("chart");
    const auto* choice = curves.findChild<QComboBox*>("curveChoice");
    curves.resize(500, 240);
    curves.show();
    cursor.setRun(test::slidingRun(path("a.kbrun"), 0.3), false);
    ASSERT_TRUE(waitFor([&] { return view->chart().has_value() && choice->count() > 1; }));
    EXPECT_TRUE(choice->currentText().endsWith("(mm)")) << choice->currentText().toStdString();
    const int chosen = choice->currentIndex();
    display.setSystem(UnitSystem::Si);
    EXPECT_TRUE(choice->currentText().endsWith("(m)")) << choice->currentText().toStdString();
    EXPECT_EQ(choice->currentIndex(), chosen);
    EXPECT_TRUE(view->chart()->panels[0].title.ends_with("(m)"));
    display.setSystem(UnitSystem::Engineering);
}

TEST_F(CurvesTest, AnyQuantityIsPlottedAgainstAnotherTogetherWithASecondRun) {
    Themes themes;
    TimeCursor cursor;
    Pins pins(cursor);
    Display display;
    Curves curves(themes, display, cursor, CurveKind::All, &pins);
    auto* view = curves.findChild<ChartView*>("chart");
    curves.resize(600, 240);
    curves.show();
    const auto run = test::slidingRun(path("a.kbrun"), 0.3);
    cursor.setRun(run, false);
    ASSERT_TRUE(waitFor([&] { return view->chart().has_value(); }));
    choose(curves, "curveChoice", "Any quantity against any other");
    EXPECT_TRUE(curves.findChild<QWidget*>("axisChoice")->isVisible());
    EXPECT_TRUE(view->chart()->overTime);
    choose(curves, "curveX", QString::fromUtf8("slider · ux"));
    choose(curves, "curveY", QString::fromUtf8("energy · kinetic"));
    ASSERT_TRUE(waitFor([&] {
        return view->chart() && view->chart()->xTitle == "slider.ux (mm)" &&
               view->chart()->panels[0].title.starts_with("Energy");
    }));
    EXPECT_EQ(view->chart()->panels[0].curves[0].x.size(), run->frames().size());
    Q_EMIT view->picked(view->chart()->panels[0].curves[0].x[4]);
    EXPECT_EQ(cursor.frame(), 4u);
    const auto other = test::slidingRun(path("b.kbrun"), 0.6);
    const double alone = view->chart()->x.high;
    curves.setOther(other, "Run 2");
    ASSERT_TRUE(waitFor([&] { return view->chart()->panels[0].curves.size() == 2; }));
    EXPECT_TRUE(view->chart()->panels[0].curves[1].ofOther);
    EXPECT_GT(view->chart()->x.high, alone);
    curves.setOther(nullptr, {});
    EXPECT_EQ(view->chart()->panels[0].curves.size(), 1u);
    cursor.setRun(nullptr, false);
    curves.setOther(other, "Run 2");  // without a first run nothing is drawn
    EXPECT_FALSE(view->chart());
}

TEST(CurveEntries, ASecondRunIsPlottedAtTheSameStageTimes) {
    const auto entryOf = [](std::vector<StageSpan> stages, std::vector<double> x) {
        CurveEntry entry;
        entry.chart.overTime = true;
        entry.chart.stages = std::move(stages);
        entry.chart.x = {0.0, entry.chart.stages.back().to};
        ChartPanel panel;
        panel.curves.push_back({"", CurveStyle::Main, x, std::vector<double>(x.size(), 1.0)});
        entry.chart.panels = {panel};
        return entry;
    };
    const std::vector<StageSpan> own{{0, "settle", 0.0, 1.0, 1.0}, {1, "burst", 1.0, 4.0, 0.008}};
    CurveEntry shown = entryOf(own, {0.5, 2.5});
    addOther(shown, entryOf({{0, "settle", 0.0, 1.0, 1.0}, {1, "burst", 1.0, 4.0, 0.004}}, {0.5, 2.5, 4.0}), "Run 2");
    EXPECT_EQ(shown.chart.panels[0].curves[0].x, (std::vector<double>{0.5, 2.5}));
    EXPECT_EQ(shown.chart.panels[0].curves[1].x, (std::vector<double>{0.5, 1.75, 2.5}));  // that run got half as far
    EXPECT_EQ(shown.chart.x.high, 4.0);
    shown = entryOf(own, {0.5, 2.5});  // one that continued
    addOther(shown, entryOf({{0, "settle", 0.0, 1.0, 1.0}, {1, "burst", 1.0, 4.0, 0.016}, {2, "rest", 4.0, 5.0, 1.0}},
                            {4.0, 4.5}),
             "Run 2");
    EXPECT_EQ(shown.chart.panels[0].curves[1].x, (std::vector<double>{7.0, 7.5}));
    EXPECT_EQ(shown.chart.x.high, 8.0);
    EXPECT_EQ(shown.chart.dividers, (std::vector<double>{1.0, 7.0}));
}

/// Rows as of a long run with many bolts.
LiveBatch longHistory(const LiveRun& run, std::size_t rows) {
    LiveBatch batch;
    HistoryRow row = run.history().back();
    row.values.resize(2000);
    for (std::size_t i = 0; i < rows; ++i) {
        row.time += 1e-5;
        row.values[0] = static_cast<double>(i);
        batch.history.push_back(row);
    }
    return batch;
}

TEST_F(CurvesTest, ALongHistoryDoesNotBlockTheWindow) {
    Themes themes;
    TimeCursor cursor;
    Pins pins(cursor);
    Display display;
    Curves curves(themes, display, cursor, CurveKind::All, &pins);
    auto* view = curves.findChild<ChartView*>("chart");
    curves.resize(500, 240);
    curves.show();
    const auto run = test::slidingRun(path("a.kbrun"), 0.3);
    run->append(longHistory(*run, 20000));
    cursor.setRun(run, true);
    EXPECT_FALSE(view->chart()) << "the history is read in the background";
    ASSERT_TRUE(waitFor([&] { return view->chart().has_value(); }));
    const double last = view->chart()->panels.at(0).curves.at(0).x.back();
    run->append(longHistory(*run, 20000));
    for (int i = 0; i < 5; ++i) cursor.goTo(static_cast<std::size_t>(i));
    EXPECT_EQ(view->chart()->panels.at(0).curves.at(0).x.back(), last) << "another moment needs no reading";
}

TEST(HistoryLog, ACopyThatWasHandedOutDoesNotGrow) {
    HistoryLog log;
    std::vector<HistoryLog> copies;
    double time = 0.0;
    for (const std::size_t count : {1, 3, 0, 250, 10, 2000, 1, 1}) {
        std::vector<HistoryRow> rows(count);
        for (HistoryRow& row : rows) row.time = time++;
        log.append(rows);
        copies.push_back(log);
    }
    EXPECT_EQ(log.size(), 2266u);
    std::size_t size = 0, i = 0;
    for (const std::size_t count : {1, 3, 0, 250, 10, 2000, 1, 1}) {
        size += count;
        EXPECT_EQ(copies[i].all().size(), size);
        EXPECT_EQ(copies[i++].size(), size);
    }
    for (std::size_t row = 0; row < log.size(); ++row) EXPECT_EQ(log[row].time, static_cast<double>(row));
}

TEST_F(CurvesTest, OnlyOneKindOfArrowsIsDrawn) {
    Themes themes;
    Commands commands(themes);
    ViewSettings settings;
    ViewBar bar(themes, commands, settings);
    bar.resize(1200, 36);
    bar.show();
    const auto click = [&](const char* name) { QTest::mouseClick(bar.findChild<QToolButton*>(name), Qt::LeftButton); };
    auto* arrows = bar.findChild<QComboBox*>("viewArrows");
    const auto choose = [&](const QString& kind) {
        arrows->setCurrentIndex(arrows->findText(kind));
        Q_EMIT arrows->activated(arrows->currentIndex());
    };
    choose("velocity");
    EXPECT_EQ(settings.choice().arrows, ArrowKind::Velocities);
    choose("principal stresses");
    EXPECT_EQ(settings.choice().arrows, ArrowKind::StressCrosses);
    click("viewContacts");
    EXPECT_EQ(settings.choice().arrows, ArrowKind::StressCrosses);
    EXPECT_TRUE(settings.choice().contacts);
    choose("none");
    EXPECT_FALSE(settings.choice().arrows);
}

}  // namespace
}  // namespace keyblock
