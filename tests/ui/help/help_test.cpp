// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Commands are found by typed text, shortcuts can be changed and conflicts are
// reported, and help opens at the right place.
#include "tests/ui/screen/screen.h"

#include "solver/scene/field.h"
#include "ui/help/command_match.h"
#include "ui/help/command_palette.h"
#include "ui/help/help_pages.h"
#include "ui/help/help_view.h"
#include "ui/help/key_sheet.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"

#include <QAbstractTextDocumentLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextLayout>
#include <QTreeWidget>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

struct Room {
    Room() : commands(themes) {
        commands.add({"run.start", "Run", "Run", "play", "Runs all stages.", {QKeySequence("F5")}}, [this] { ++runs; });
        commands.add({"run.stop", "Stop", "Run", "stop", {}, {QKeySequence("Shift+F5")}}, [] {});
        commands.add({"view.fit", "Zoom to fit", "View", "fit", {}, {QKeySequence("F")}}, [] {});
        window.resize(900, 700);
        window.show();
    }
    Themes themes;
    Commands commands;
    QWidget window;
    int runs = 0;
};

TEST(Matches, MatchesAtTheStartOfWordsComeFirst) {
    EXPECT_GT(matchOf("fit", "Zoom to fit"), matchOf("fit", "Profit"));
    EXPECT_GT(matchOf("zo fi", "Zoom to fit"), 0);
    EXPECT_GT(matchOf("ztf", "Zoom to fit"), 0);
    EXPECT_LT(matchOf("xyz", "Zoom to fit"), 0);
    EXPECT_EQ(matchOf("", "Zoom to fit"), 0);
}

TEST(Palettes, TypingAndEnterRunsTheCommand) {
    NEED_SCREEN();
    Room room;
    CommandPalette palette(room.commands, room.themes, &room.window);
    palette.open();
    auto* typed = palette.findChild<QLineEdit*>("palette.typed");
    QTest::keyClicks(typed, "ru");
    EXPECT_EQ(palette.findChild<QListWidget*>("palette.found")->currentItem()->text(), "Run");
    QTest::keyClick(typed, Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return room.runs == 1; }));
    EXPECT_FALSE(palette.isVisible());
    palette.open();
    EXPECT_EQ(palette.findChild<QListWidget*>("palette.found")->item(0)->text(), "Run");  // used last
    QTest::keyClick(typed, Qt::Key_Escape);
    EXPECT_FALSE(palette.isVisible());
}

TEST(Palettes, ShortcutInATextFieldOpensItAndTheFocusReturns) {
    NEED_SCREEN();
    Room room;
    CommandPalette palette(room.commands, room.themes, &room.window);
    QAction* search = room.commands.add({"help.palette", "Search commands", "Help", {}, {}, {QKeySequence("Ctrl+K")}},
                                        [&] { palette.open(); });
    room.window.addAction(search);
    QLineEdit before(&room.window), field(&room.window);
    for (QLineEdit* line : {&before, &field}) line->show();
    field.setText("Drift");
    room.window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&room.window));
    field.setFocus();
    field.setCursorPosition(2);
    QTest::keyClick(&field, Qt::Key_K, Qt::ControlModifier);
    EXPECT_TRUE(palette.isVisible());
    EXPECT_EQ(field.text(), "Drift");
    auto* typed = palette.findChild<QLineEdit*>("palette.typed");
    EXPECT_TRUE(typed->hasFocus());
    QTest::keyClick(typed, Qt::Key_Escape);
    EXPECT_FALSE(palette.isVisible());
    EXPECT_TRUE(field.hasFocus());
    palette.open();
    QTest::keyClicks(typed, "ru");
    QTest::keyClick(typed, Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return room.runs == 1; }));
    EXPECT_TRUE(field.hasFocus());
}

TEST(Palettes, UnavailableCommandsComeLastAndNoMatchIsReported) {
    NEED_SCREEN();
    Room room;
    room.commands.setWhyNot("run.start", "Nothing to run");
    CommandPalette palette(room.commands, room.themes, &room.window);
    palette.open();
    const auto* found = palette.findChild<QListWidget*>("palette.found");
    ASSERT_EQ(found->count(), 3);
    EXPECT_EQ(found->item(2)->text(), "Run");
    const auto* none = palette.findChild<QLabel*>("palette.none");
    EXPECT_TRUE(none->isHidden());
    QTest::keyClicks(palette.findChild<QLineEdit*>("palette.typed"), "zzz");
    EXPECT_EQ(found->count(), 0);
    EXPECT_TRUE(none->isVisible() && none->text().contains("zzz"));
}

TEST(CommandTexts, ShowTheCurrentKeysAndWhyACommandIsDisabled) {
    NEED_SCREEN();
    Room room;
    QAction* run = room.commands.action("run.start");
    EXPECT_EQ(room.commands.callOf("run.start"), "F5");
    room.commands.setKeys("run.start", {QKeySequence("F4")});
    EXPECT_EQ(room.commands.callOf("run.start"), "F4");
    room.commands.setKeys("run.start", {QKeySequence()});
    EXPECT_EQ(room.commands.callOf("run.start"), QString::fromUtf8("“Run”"));
    room.commands.setKeys("run.start", {});
    room.commands.setWhyNot("run.start", "Nothing to run.");
    EXPECT_FALSE(run->isEnabled());
    EXPECT_TRUE(run->toolTip().endsWith("Nothing to run.")) << run->toolTip().toStdString();
    room.commands.setWhyNot("run.start", {});
    EXPECT_TRUE(run->isEnabled());
    EXPECT_FALSE(run->toolTip().contains("Nothing to run."));
}

TEST(KeySheets, ANewShortcutIsTakenFromTheOtherCommand) {
    NEED_SCREEN();
    Room room;
    KeySheet sheet(room.commands, room.themes);
    auto* list = sheet.findChild<QTreeWidget*>("keySheet.list");
    list->setCurrentItem(list->findItems("Zoom to fit", Qt::MatchExactly | Qt::MatchRecursive).first());
    sheet.findChild<QKeySequenceEdit*>()->setKeySequence(QKeySequence("F5"));
    EXPECT_EQ(commandWithKeys(room.commands, QKeySequence("F5"), room.commands.action("view.fit")),
              room.commands.action("run.start"));
    sheet.findChild<QPushButton*>("keySheet.Set")->click();
    EXPECT_EQ(room.commands.action("view.fit")->shortcut(), QKeySequence("F5"));
    EXPECT_TRUE(room.commands.action("run.start")->shortcut().isEmpty());
    list->setCurrentItem(list->findItems("Run", Qt::MatchExactly | Qt::MatchRecursive).last());  // not the menu
    sheet.findChild<QPushButton*>("keySheet.Restore default")->click();
    EXPECT_EQ(room.commands.action("run.start")->shortcut(), QKeySequence("F5"));
    EXPECT_TRUE(room.commands.action("view.fit")->shortcut().isEmpty());  // a key of two commands would do nothing
    room.commands.setKeys("view.fit", {});
}

TEST(HelpPages, EveryPageExistsAndIsSearched) {
    NEED_SCREEN();
    ASSERT_FALSE(helpPages().empty());
    EXPECT_EQ(helpPages().front().name, "studio");
    for (const char* name : {"studio", "scene", "theory"}) EXPECT_TRUE(findHelpPage(name)) << name;
    const std::vector<HelpHit> hits = searchHelp("journal");
    ASSERT_FALSE(hits.empty());
    EXPECT_EQ(hits.front().page->name, "studio");
    EXPECT_TRUE(searchHelp("no such word at all").empty());
}

TEST(HelpViews, EveryFieldIsFoundUnderItsObject) {
    NEED_SCREEN();
    Themes themes;
    HelpView view(themes);
    view.resize(500, 600);
    view.open("scene", "bolt pattern/length");
    const auto* text = view.findChild<QTextBrowser*>("help.text");
    EXPECT_EQ(text->textCursor().selectedText(), "length");
    QTextCursor above = text->textCursor();
    while (above.block().isValid() && above.blockFormat().headingLevel() == 0)
        if (!above.movePosition(QTextCursor::PreviousBlock)) break;
    EXPECT_EQ(above.block().text().toStdString(), "bolt pattern");
}

TEST(HelpViews, AToolIsFoundUnderTools) {
    NEED_SCREEN();
    Themes themes;
    HelpView view(themes);
    for (const char* tool : {"Block", "Joint set", "Bolt pattern", "Measure"}) {
        view.open("studio", QString("Tools/") + tool);
        const QTextCursor found = view.findChild<QTextBrowser*>("help.text")->textCursor();
        EXPECT_EQ(found.selectedText().toStdString(), tool);
        EXPECT_TRUE(found.block().text().startsWith(tool)) << found.block().text().toStdString();
    }
}

TEST(HelpViews, FormulasAreNotWrapped) {
    NEED_SCREEN();
    Themes themes;
    HelpView view(themes);
    view.resize(300, 600);
    view.show();
    view.open("theory", {});
    const QTextDocument& page = *view.findChild<QTextBrowser*>("help.text")->document();
    const QTextBlock formula = page.find("M/ρt =").block();
    ASSERT_TRUE(formula.isValid());
    page.documentLayout()->documentSize();  // lays the page out
    EXPECT_EQ(formula.layout()->lineCount(), formula.text().count(QChar(QChar::LineSeparator)) + 1);
}

TEST(HelpViews, TheNearestTopicIsUsed) {
    NEED_SCREEN();
    QWidget outer;
    outer.setProperty("helpTopic", "studio");
    QWidget inner(&outer);
    EXPECT_EQ(helpTopicOf(&inner), "studio");
    inner.setProperty("helpTopic", "scene#bolt/length");
    EXPECT_EQ(helpTopicOf(&inner), "scene#bolt/length");
    EXPECT_EQ(helpTopicOf(nullptr), "");
}

}  // namespace
}  // namespace keyblock
