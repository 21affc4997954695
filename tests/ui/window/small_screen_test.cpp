// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window on small laptop screens: every panel has room for its main content, and
// controls without room are in a menu. Help and layouts keep widths.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "ui/docks/bolt_strip.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/curves.h"
#include "ui/docks/view_bar.h"
#include "ui/document/document.h"
#include "ui/help/help_view.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/runs/runs.h"
#include "ui/runs/stress_runs.h"
#include "ui/runs/time_cursor.h"
#include "ui/window/main_window.h"
#include "ui/window/workflow_bar.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include <filesystem>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class SmallScreens : public testing::TestWithParam<QSize> {
protected:
    void SetUp() override {
        NEED_SCREEN();
        QSettings().clear();
        themes_ = std::make_unique<Themes>();
        window_ = std::make_unique<MainWindow>(*themes_);
        window_->resize(GetParam());
        window_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    }
    void TearDown() override { QSettings().clear(); }

    void open(const std::string& sample) {
        const fs::path copy = folder_.path() / (sample + ".json");
        fs::copy_file(fs::path(KEYBLOCK_SAMPLES_DIR) / (sample + ".json"), copy);
        window_->openPath(QString::fromStdString(copy.string()));
        auto* document = window_->findChild<Document*>();
        ASSERT_TRUE(waitFor([&] { return document->checkIsCurrent() && document->checked().picture; }));
    }

    void run() {
        Runs& runs = *window_->findChild<Runs*>();
        runs.start();
        ASSERT_TRUE(waitFor([&] { return !runs.isRunning(); }, 60000));
        ASSERT_TRUE(window_->findChild<TimeCursor*>()->hasMoment());
    }

    test::ScratchFolder folder_;
    std::unique_ptr<Themes> themes_;
    std::unique_ptr<MainWindow> window_;
};

/// Whether the whole widget is visible.
bool isWhole(const QWidget& widget) {
    return widget.isVisible() && widget.visibleRegion().boundingRect() == widget.rect();
}

TEST_P(SmallScreens, RunButtonOfTheModelSummaryIsNotCut) {
    open("rebar-stated");
    auto* time = window_->findChild<QWidget*>("estimatedTime");
    ASSERT_TRUE(time);
    QPushButton* run = nullptr;
    for (auto* button : window_->findChild<QWidget*>("modelSummaryCosts")->findChildren<QPushButton*>()) run = button;
    ASSERT_TRUE(run);
    EXPECT_TRUE(waitFor([&] { return isWhole(*run) && isWhole(*time); }))
        << run->visibleRegion().boundingRect().height() << " of " << run->height() << " px";
    EXPECT_TRUE(waitFor([&] { return time->height() >= time->sizeHint().height(); }, 5000))
        << time->height() << " of " << time->sizeHint().height() << " px";
}

TEST_P(SmallScreens, BoltDiagramCurvesAndStageAreDrawn) {
    open("rebar-stated");
    run();
    for (QWidget* dock : {static_cast<QWidget*>(window_->findChild<BoltStrip*>()),
                          static_cast<QWidget*>(window_->findChild<Curves*>("curves"))}) {
        const auto* chart = dock->findChild<ChartView*>();
        EXPECT_TRUE(waitFor([&] { return chart->isDrawn(); }))
            << dock->objectName().toStdString() << " is " << chart->width() << " x " << chart->height() << " px";
    }
    const auto* stage = window_->findChild<QLabel*>("timeStage");
    EXPECT_TRUE(waitFor([&] { return stage->width() >= stage->sizeHint().width(); }, 5000)) << stage->width();
}

TEST_P(SmallScreens, ViewControlsWithoutRoomAreInTheMenu) {
    open("rebar-stated");
    run();
    auto* bar = window_->findChild<ViewBar*>();
    auto* more = bar->findChild<QToolButton*>("viewMore");
    ASSERT_TRUE(waitFor([&] { return bar->isVisible() && more; }));
    settle();
    const auto isInMenu = [&](const QWidget& control) {
        Q_EMIT more->menu()->aboutToShow();
        QStringList offered;
        for (const QAction* action : more->menu()->actions()) offered << action->text();
        return control.isHidden() && offered.contains(control.accessibleName());
    };
    for (const char* name : {"viewBlocks", "viewBolts", "viewFactor", "viewArrows", "export.figureBar"}) {
        const auto* control = bar->findChild<QWidget*>(name);
        EXPECT_TRUE(waitFor([&] { return isWhole(*control) || isInMenu(*control); })) << name;
    }
    for (const auto* box : bar->findChildren<QComboBox*>())  // no choice is elided
        EXPECT_TRUE(!box->isVisible() || box->width() >= box->sizeHint().width()) << box->objectName().toStdString();
}

TEST_P(SmallScreens, PanelsOfAnotherArrangementOpenAsTabs) {
    open("rebar-stated");
    run();
    const auto dock = [this](const char* name) { return window_->findChild<QDockWidget*>(name); };
    settle();
    const int strip = dock("stripDock")->width(), curves = dock("curvesDock")->width();
    const Commands& commands = *window_->findChild<Commands*>();
    commands.action("run.stress")->trigger();
    window_->findChild<StressRuns*>()->stop();
    settle();
    EXPECT_TRUE(dock("stressDock")->isVisible());
    commands.action("dock.problemsDock")->trigger();
    settle();
    EXPECT_TRUE(dock("problemsDock")->isVisible());
    for (const char* name : {"stressDock", "problemsDock"})
        EXPECT_TRUE(window_->tabifiedDockWidgets(dock("stripDock")).contains(dock(name))) << name;
    EXPECT_EQ(dock("problemsDock")->width(), strip);
    EXPECT_EQ(dock("curvesDock")->width(), curves);
    window_->findChild<WorkflowBar*>()->choose(WorkStep::Geometry);
    EXPECT_TRUE(waitFor([&] { return dock("problemsDock")->isVisible() && dock("curvesDock")->isHidden(); }));
    EXPECT_FALSE(window_->tabifiedDockWidgets(dock("stripDock")).contains(dock("problemsDock")));
}

INSTANTIATE_TEST_SUITE_P(Sizes, SmallScreens,
                         testing::Values(QSize(1366, 728), QSize(1280, 680), QSize(1280, 800), QSize(1400, 900),
                                         QSize(1600, 960)));

class Widths : public SmallScreens {};

TEST_P(Widths, HelpGivesPropertiesTheirWidthBackAndResetRestoresAll) {
    auto* properties = window_->findChild<QDockWidget*>("propertyDock");
    auto* help = window_->findChild<QDockWidget*>("helpDock");
    const Commands& commands = *window_->findChild<Commands*>();
    settle();
    const int before = properties->width();
    commands.action("help.theory")->trigger();
    EXPECT_TRUE(waitFor([&] { return help->isVisible() && help->width() > before; })) << help->width();
    help->findChild<QToolButton*>("help.close")->click();
    EXPECT_TRUE(waitFor([&] { return properties->isVisible() && properties->width() == before; }))
        << properties->width() << " instead of " << before;
    commands.action("help.theory")->trigger();
    EXPECT_TRUE(waitFor([&] { return help->isVisible() && help->width() > before; })) << help->width();
    settle();
    properties->setFloating(true);
    commands.action("view.resetLayout")->trigger();
    EXPECT_TRUE(waitFor([&] { return !help->isVisible() && !properties->isFloating() && properties->width() == before; }))
        << properties->width() << " instead of " << before;
}

INSTANTIATE_TEST_SUITE_P(Sizes, Widths, testing::Values(QSize(1440, 860)));

}  // namespace
}  // namespace keyblock
