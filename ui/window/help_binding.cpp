// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_binding.h"

#include "ui/help/command_palette.h"
#include "ui/help/help_view.h"
#include "ui/help/key_sheet.h"
#include "ui/help/search_box.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/window/dock.h"
#include "ui/window/help_width.h"

#include <QApplication>
#include <QCursor>
#include <QDockWidget>
#include <QMainWindow>

namespace keyblock {

namespace {

/// Help topic of the field or tool under the cursor, or else of the one that has the focus.
QString topicAtHand() {
    const QString pointed = helpTopicOf(QApplication::widgetAt(QCursor::pos()));
    return pointed.isEmpty() ? helpTopicOf(QApplication::focusWidget()) : pointed;
}

void showHelp(QDockWidget& dock, HelpView& view, const QString& topic) {
    dock.show();
    dock.raise();
    view.open(topic.section('#', 0, 0), topic.section('#', 1));
}

/// Makes the list of shortcuts in a separate window, so that it can stay open during work.
KeySheet* makeKeySheet(QMainWindow& window, Commands& commands, const Themes& themes) {
    auto* sheet = new KeySheet(commands, themes, &window);
    sheet->setWindowFlag(Qt::Window);
    sheet->setWindowTitle(QMainWindow::tr("Keyboard shortcuts"));
    sheet->resize(760, 680);
    return sheet;
}

}  // namespace

QWidget* addHelp(QMainWindow& window, Commands& commands, const Themes& themes) {
    auto* view = new HelpView(themes, &window);
    QDockWidget* dock = makeDock(window, themes, "helpDock", QMainWindow::tr("Help"), view);
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    if (auto* properties = window.findChild<QDockWidget*>("propertyDock")) {
        window.tabifyDockWidget(properties, dock);
        new HelpWidth(window, *dock, *properties);
    }
    dock->hide();
    QObject::connect(view, &HelpView::closeWanted, dock, &QDockWidget::hide);
    auto* palette = new CommandPalette(commands, themes, &window);
    QAction* search = commands.add({"help.palette", QMainWindow::tr("Search commands"), "Help", "search",
                                    QMainWindow::tr("Finds a command by its name."), {QKeySequence("Ctrl+K")}, false, "find"},
                                   [palette] { palette->open(); });
    commands.add({"help.contents", QMainWindow::tr("Manual"), "Help", "book",
                  QMainWindow::tr("Opens help on the field or tool under the cursor, or on the window."), {QKeySequence("F1")}, false,
                  "pages"},
                 [dock, view] {
                     const QString topic = topicAtHand();
                     showHelp(*dock, *view, topic.isEmpty() ? "studio" : topic);
                 });
    commands.add({"help.scene", QMainWindow::tr("Scene fields"), "Help", {},
                  QMainWindow::tr("Lists every field with its unit, default and range."), {}, false, "pages"},
                 [dock, view] { showHelp(*dock, *view, "scene"); });
    commands.add({"help.theory", QMainWindow::tr("Theory"), "Help", {}, QMainWindow::tr("Explains the equations and how they are solved."), {}, false, "pages"},
                 [dock, view] { showHelp(*dock, *view, "theory"); });
    commands.add({"help.verification", QMainWindow::tr("Verification"), "Help", "verify",
                  QMainWindow::tr("Lists the verification cases and explains how to repeat them."), {}, false, "pages"},
                 [dock, view] { showHelp(*dock, *view, "verification"); });
    commands.add({"help.security",
                  QMainWindow::tr("Security"),
                  "Help",
                  {},
                  QMainWindow::tr("Explains what files from others can and cannot do."),
                  {},
                  false,
                  "pages"},
                 [dock, view] { showHelp(*dock, *view, "security"); });
    commands.add({"help.keys", QMainWindow::tr("Keyboard shortcuts"), "Help", "keyboard",
                  QMainWindow::tr("Lists all commands and their shortcuts, which can be changed."),
                  {QKeySequence("?")}, false, "find"},
                 [&window, &commands, &themes, sheet = static_cast<KeySheet*>(nullptr)]() mutable {
                     if (!sheet) sheet = makeKeySheet(window, commands, themes);
                     sheet->show();
                     sheet->raise();
                     sheet->activateWindow();
                 });
    return new SearchBox(*search, themes, &window);
}

}  // namespace keyblock
