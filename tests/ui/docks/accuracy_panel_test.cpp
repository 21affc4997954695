// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Accuracy and time in the window: the runs, Stop, and settings used by a click.
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"
#include "solver/trade/trade_errors.h"
#include "ui/docks/accuracy_panel.h"
#include "ui/docks/trade_view.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/runs/trade_runs.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

class AccuracyPanelTest : public ::testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        panel_ = std::make_unique<AccuracyPanel>(themes_, document_, runs_);
        panel_->resize(700, 320);
        panel_->show();
    }

    void open(Scene scene) {
        document_.startNew(std::move(scene));
        ASSERT_TRUE(waitFor([&] { return document_.checkIsCurrent(); }));
    }

    /// A short slide with few runs.
    static Scene shortSlide() {
        Scene scene = test::sample("incline.json");
        scene.stages.back().duration = 0.02;
        return scene;
    }

    QString text(const char* name) const { return panel_->findChild<QLabel*>(name)->text(); }

    Themes themes_;
    Document document_;
    TradeRuns runs_{document_};
    std::unique_ptr<AccuracyPanel> panel_;
};

TEST_F(AccuracyPanelTest, ClickOnADotUsesItsSettingsAsOneUndoStep) {
    open(shortSlide());
    panel_->findChild<QPushButton*>("accuracy.start")->click();
    EXPECT_TRUE(runs_.isBusy());
    ASSERT_TRUE(waitFor([&] { return !runs_.isBusy(); }, 15000));
    EXPECT_TRUE(text("accuracyAnswer").contains("of the finest run")) << text("accuracyAnswer").toStdString();
    const auto& points = runs_.trade().points;
    const auto sketch = std::find_if(points.begin(), points.end(),
                                     [](const TradePoint& point) { return point.setting == "sketch"; });
    ASSERT_NE(sketch, points.end());
    const auto sketchDot = static_cast<std::size_t>(sketch - points.begin());
    auto* chart = panel_->findChild<TradeView*>("tradeView");
    ASSERT_TRUE(chart->placeOf(sketchDot));
    std::vector<std::optional<QPoint>> places;
    for (std::size_t i = 0; i < points.size(); ++i)
        places.push_back(static_cast<int>(i) == runs_.trade().reference ? std::nullopt : chart->placeOf(i));
    const QPoint place = *places[sketchDot];
    QSignalSpy picks(chart, &TradeView::picked);
    QTest::mouseClick(chart, Qt::LeftButton, {}, place);
    ASSERT_EQ(picks.count(), 1);
    const QPoint picked = places[static_cast<std::size_t>(picks.front().front().toInt())].value();
    EXPECT_LE((picked - place).manhattanLength(), 2);  // dots of runs that take the same time coincide
    document_.undo().setIndex(0);
    const Scene before = *document_.committed();
    Q_EMIT chart->picked(static_cast<int>(sketchDot));
    EXPECT_EQ(document_.undo().count(), 1);
    EXPECT_EQ(document_.committed()->analysis.preset, Preset::Sketch);
    EXPECT_TRUE(text("accuracyDetail").contains("now uses")) << text("accuracyDetail").toStdString();
    document_.undo().undo();
    EXPECT_EQ(*document_.committed(), before);
}

TEST_F(AccuracyPanelTest, StopKeepsTheRunsMadeAndAnEmptySceneIsRefused) {
    panel_->findChild<QPushButton*>("accuracy.start")->click();
    EXPECT_FALSE(runs_.isBusy()) << "an empty scene has nothing to run";
    EXPECT_FALSE(text("accuracyAnswer").isEmpty());
    open(test::sample("incline.json"));
    panel_->findChild<QPushButton*>("accuracy.start")->click();
    ASSERT_TRUE(waitFor([&] { return !runs_.trade().points.empty(); }, 15000));
    panel_->findChild<QPushButton*>("accuracy.stop")->click();
    ASSERT_TRUE(waitFor([&] { return !runs_.isBusy(); }, 5000));
    EXPECT_FALSE(runs_.trade().points.empty());
}

TEST_F(AccuracyPanelTest, SaysThatTheSceneHasChanged) {
    open(shortSlide());
    runs_.start();
    ASSERT_TRUE(waitFor([&] { return !runs_.isBusy(); }, 15000));
    EXPECT_TRUE(text("accuracyDetail").isEmpty());
    Scene changed = *document_.committed();
    changed.title = "another";
    document_.apply("rename", changed);
    EXPECT_TRUE(text("accuracyDetail").contains("has changed"));
}

}  // namespace
}  // namespace keyblock
