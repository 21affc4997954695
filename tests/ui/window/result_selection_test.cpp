// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clicks on the section while results are shown: blocks and bolts are selected,
// Properties shows their results, and the right button opens a menu.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "ui/canvas/canvas.h"
#include "ui/docks/quantity_table.h"
#include "ui/docks/result_card.h"
#include "ui/document/document.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/panels/properties/property_panel.h"
#include "ui/runs/block_choice.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"
#include "ui/window/main_window.h"
#include "ui/window/result_selection.h"

#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class ResultSelections : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        themes_ = std::make_unique<Themes>();
        window_ = std::make_unique<MainWindow>(*themes_);
        window_->findChild<Display*>()->setSystem(UnitSystem::Engineering);
        window_->show();
        canvas_ = window_->findChild<Canvas*>();
        const fs::path copy = folder_.path() / "rebar-20.json";
        fs::copy_file(fs::path(KEYBLOCK_SAMPLES_DIR) / "rebar-20.json", copy);
        window_->openPath(QString::fromStdString(copy.string()));
        auto* document = window_->findChild<Document*>();
        ASSERT_TRUE(waitFor([&] { return document->checkIsCurrent() && document->checked().picture; }));
        Runs& runs = *window_->findChild<Runs*>();
        runs.start();
        ASSERT_TRUE(waitFor([&] { return !runs.isRunning(); }, 60000));
        ASSERT_TRUE(waitFor([&] { return canvas_->picture() && !canvas_->picture()->bolts.empty(); }));
        canvas_->zoomTo(canvas_->picture()->model);
    }

    QPoint pixelOf(const Point& place) const { return canvas_->map().toPixel(place).toPoint(); }
    QPoint blockPixel() const { return pixelOf(boxOf(canvas_->picture()->blocks.front().outline).min + Point(0.1, 0.1)); }
    QPoint boltPixel() const {
        const std::vector<Point>& nodes = canvas_->picture()->bolts.front().nodes;
        return pixelOf(nodes[nodes.size() / 4]);
    }
    QString title() const { return window_->findChild<PropertyPanel*>()->findChild<QLabel*>("propertyTitle")->text(); }

    test::ScratchFolder folder_;
    std::unique_ptr<Themes> themes_;
    std::unique_ptr<MainWindow> window_;
    Canvas* canvas_ = nullptr;
};

TEST_F(ResultSelections, ABlockAndABoltShowTheirResults) {
    const ResultCard& card = *window_->findChild<ResultCard*>();
    const auto& blocks = *window_->findChild<BlockChoice*>();
    QTest::mouseClick(canvas_, Qt::LeftButton, {}, blockPixel());
    EXPECT_GE(blocks.block(), 0);
    ASSERT_TRUE(waitFor([&] { return card.report() != nullptr && card.isVisible(); }));
    EXPECT_TRUE(title().startsWith("Block ")) << title().toStdString();
    const auto valueOf = [&](const QString& name) {
        const auto& all = card.report()->rows;
        const auto row = std::ranges::find_if(all, [&](const ResultRow& each) { return each.name == name; });
        return row == all.end() ? QString() : row->value;
    };
    EXPECT_TRUE(valueOf("Largest σ₁").endsWith(" MPa")) << valueOf("Largest σ₁").toStdString();
    QTest::mouseClick(canvas_, Qt::LeftButton, {}, boltPixel());
    EXPECT_EQ(window_->findChild<BoltChoice*>()->bolt(), 0);
    EXPECT_EQ(blocks.block(), -1);
    ASSERT_TRUE(waitFor([&] { return card.report() && card.report()->title.contains("bolt"); }));
    const auto& rows = card.report()->rows;
    EXPECT_EQ(rows.front().value, "yielded");
    const auto largest = std::ranges::find_if(rows, [](const ResultRow& row) { return row.name == "Largest N"; });
    ASSERT_NE(largest, rows.end());
    EXPECT_TRUE(largest->value.startsWith("195")) << largest->value.toStdString();
    const auto steel = std::ranges::find_if(rows, [](const ResultRow& row) { return row.name == "Steel utilisation"; });
    ASSERT_NE(steel, rows.end());
    EXPECT_TRUE(steel->detail.startsWith("of ultimate strength, ")) << steel->detail.toStdString();
    EXPECT_TRUE(valueOf("Energy absorbed so far").endsWith(" kJ")) << valueOf("Energy absorbed so far").toStdString();
    EXPECT_TRUE(valueOf("Largest M").isEmpty() || valueOf("Largest M") == "0" || valueOf("Largest M").endsWith(" kN m"));
    EXPECT_FALSE(card.report()->events.empty());
    QTest::mouseClick(canvas_, Qt::LeftButton, {}, blockPixel());
    EXPECT_EQ(window_->findChild<BoltChoice*>()->bolt(), -1);
    QTest::mouseClick(canvas_, Qt::LeftButton, {}, blockPixel());
    EXPECT_EQ(blocks.block(), -1) << "a second click takes the choice away";
    EXPECT_FALSE(card.isVisible());
}

TEST_F(ResultSelections, TheRightButtonOpensAMenuOfActions) {
    QMenu menu;
    window_->findChild<ResultSelection*>()->fillMenu(menu, boltPixel());
    QStringList entries;
    for (const QAction* action : menu.actions()) entries << action->text();
    EXPECT_TRUE(entries.contains("Show results for bolt B")) << entries.join(", ").toStdString();
    EXPECT_TRUE(entries.contains("Pin this point and plot its values over time"));
    EXPECT_FALSE(entries.filter("Delete").size());
}

TEST_F(ResultSelections, ExpectedValuesAreComparedWithMeasured) {
    auto* dock = window_->findChild<QDockWidget*>("quantitiesDock");
    dock->show();
    dock->raise();
    const auto* list = dock->findChild<QTreeWidget*>("quantities");
    ASSERT_TRUE(waitFor([&] { return list->topLevelItemCount() == 3; }));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(list->topLevelItem(i)->text(5), "met") << i;
}

}  // namespace
}  // namespace keyblock
