// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stability panel: its verdict, its tables, and where a click on them leads.
#include "ui/docks/stability_panel.h"

#include "tests/scratch_folder.h"
#include "tests/ui/bricks.h"
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/time_cursor.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QTreeWidget>

namespace keyblock {
namespace {

struct ShownPanel {
    ShownPanel() {
        document.startNew(test::bricks());
        panel.resize(900, 300);
        panel.show();
    }

    QString answer() const { return panel.findChild<QLabel*>("stabilityAnswer")->text(); }
    QTreeWidget* tree(const char* name) const { return panel.findChild<QTreeWidget*>(name); }

    void click(QTreeWidget* in, int row) {
        QTest::mouseClick(in->viewport(), Qt::LeftButton, {}, in->visualItemRect(in->topLevelItem(row)).center());
    }

    Themes themes;
    Display display;
    TimeCursor cursor;
    Selection selection;
    Document document;
    BoltChoice choice{document, selection, cursor};
    StabilityPanel panel{themes, display, cursor, choice};
};

class StabilityPanelTest : public ::testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }

    test::ScratchFolder folder_;
};

TEST_F(StabilityPanelTest, ShowsAHungBlockAsStableWithTheUtilisationOfItsBolt) {
    ShownPanel shown;
    EXPECT_FALSE(shown.answer().contains("Stable"));
    shown.cursor.setRun(test::storedRun(test::sample("suspended-block.json"), folder_.path() / "a.kbrun"), false);
    EXPECT_TRUE(shown.answer().startsWith("Stable: yes")) << shown.answer().toStdString();
    EXPECT_TRUE(shown.tree("unstableBlocks")->isHidden());
    QTreeWidget* bolts = shown.tree("boltUses");
    ASSERT_TRUE(waitFor([&] { return bolts->topLevelItemCount() == 1; }));
    const QTreeWidgetItem* row = bolts->topLevelItem(0);
    EXPECT_EQ(row->text(0), "B");
    EXPECT_EQ(row->text(1), "intact");
    EXPECT_TRUE(row->text(4).startsWith("26.5 kN at ")) << row->text(4).toStdString();  // 2.7 t of rock
    EXPECT_EQ(row->text(3), "hung");
    EXPECT_TRUE(row->text(11).endsWith("J")) << row->text(11).toStdString();
    EXPECT_GT(row->text(11).section(' ', 0, 0).replace(QString::fromUtf8("−"), "-").toDouble(), 0.0);
    shown.click(bolts, 0);
    EXPECT_EQ(shown.choice.bolt(), 0);
}

TEST_F(StabilityPanelTest, ListsAFallingBlockAndOutlinesItOnClick) {
    ShownPanel shown;
    Scene scene = test::sample("suspended-block.json");
    Block loose = scene.blocks.back();
    loose.name = "loose";
    for (Point& corner : loose.points) corner += Point(3.0, 0.0);
    scene.blocks.push_back(loose);
    shown.cursor.setRun(test::storedRun(scene, folder_.path() / "b.kbrun"), false);
    EXPECT_EQ(shown.answer(), "Stable: no");
    QTreeWidget* blocks = shown.tree("unstableBlocks");
    ASSERT_EQ(blocks->topLevelItemCount(), 1);
    EXPECT_EQ(blocks->topLevelItem(0)->text(0), "loose");
    EXPECT_EQ(blocks->topLevelItem(0)->text(1), "falls");
    int asked = -1;
    QString how;
    QObject::connect(&shown.panel, &StabilityPanel::blockAsked, &shown.panel, [&](int block, const QString& what) {
        asked = block;
        how = what;
    });
    shown.click(blocks, 0);
    EXPECT_EQ(asked, 2);
    EXPECT_EQ(how, "falls");
    shown.cursor.setRun(nullptr, false);
    EXPECT_FALSE(shown.answer().contains("Stable"));
    EXPECT_EQ(shown.tree("boltUses")->topLevelItemCount(), 0);
}

TEST_F(StabilityPanelTest, ShowsThreeBlocksAndABoltAtItsDefaultSize) {
    ShownPanel shown;
    shown.panel.resize(shown.panel.sizeHint());
    Scene scene = test::sample("suspended-block.json");
    const Block hung = scene.blocks.back();
    for (int i = 1; i <= 4; ++i) {
        Block loose = hung;
        loose.name = "loose " + std::to_string(i);
        for (Point& corner : loose.points) corner += Point(4.0 * i, 0.0);
        scene.blocks.push_back(loose);
    }
    shown.cursor.setRun(test::storedRun(scene, folder_.path() / "c.kbrun"), false);
    QTreeWidget *blocks = shown.tree("unstableBlocks"), *bolts = shown.tree("boltUses");
    ASSERT_TRUE(waitFor([&] { return bolts->topLevelItemCount() == 1; }));
    settle();
    ASSERT_GE(blocks->topLevelItemCount(), 3);
    const auto isVisible = [](const QTreeWidget* tree, int row) {
        const QRect cell = tree->visualItemRect(tree->topLevelItem(row));
        return cell.top() >= 0 && cell.bottom() < tree->viewport()->height();
    };
    EXPECT_TRUE(isVisible(blocks, 0) && isVisible(blocks, 1) && isVisible(blocks, 2));
    EXPECT_TRUE(isVisible(bolts, 0));
    EXPECT_EQ(shown.panel.height(), shown.panel.sizeHint().height());
}

TEST_F(StabilityPanelTest, ShowsABlockInALowPanelAndScrollsToTheBolts) {
    ShownPanel shown;
    shown.panel.resize(358, 142);  // in the default layout at 1366 x 768
    Scene scene = test::sample("suspended-block.json");
    auto* scroll = shown.panel.findChild<QScrollArea*>();
    shown.cursor.setRun(test::storedRun(scene, folder_.path() / "stable.kbrun"), false);
    ASSERT_TRUE(waitFor([&] { return shown.tree("boltUses")->topLevelItemCount() == 1; }));
    settle();
    EXPECT_EQ(scroll->verticalScrollBar()->maximum(), 0);
    Block loose = scene.blocks.back();
    loose.name = "loose";
    for (Point& corner : loose.points) corner += Point(3.0, 0.0);
    scene.blocks.push_back(loose);
    shown.cursor.setRun(test::storedRun(scene, folder_.path() / "d.kbrun"), false);
    QTreeWidget *blocks = shown.tree("unstableBlocks"), *bolts = shown.tree("boltUses");
    ASSERT_TRUE(waitFor([&] { return bolts->topLevelItemCount() == 1; }));
    settle();
    const auto showsFirstRow = [](const QTreeWidget* tree) {
        const QRect row = tree->visualItemRect(tree->topLevelItem(0));
        const QRegion seen = tree->viewport()->visibleRegion();
        return seen.contains(row.topLeft() + QPoint(5, 3)) && seen.contains(row.bottomLeft() + QPoint(5, -3));
    };
    EXPECT_TRUE(showsFirstRow(blocks));
    scroll->ensureWidgetVisible(bolts);
    EXPECT_TRUE(showsFirstRow(bolts));
}

}  // namespace
}  // namespace keyblock
