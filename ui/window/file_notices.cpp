// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_notices.h"

#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/look/notice_bar.h"
#include "ui/look/theme.h"
#include "ui/start/reading_report.h"
#include "ui/window/dock.h"

#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QTimer>

#include <cassert>

namespace keyblock {

namespace {

void addReadingReport(QMainWindow& window, Document& document, const Themes& themes) {
    auto* report = new ReadingReport(themes, &window);
    QDockWidget* dock = makeDock(window, themes, "readingDock", QMainWindow::tr("File errors"), report);
    window.addDockWidget(Qt::BottomDockWidgetArea, dock);
    dock->hide();
    QObject::connect(&document, &Document::readInPart, dock, [&window, dock, report](const PartReading& reading) {
        report->show(reading);
        if (auto* problems = window.findChild<QDockWidget*>("problemsDock")) window.tabifyDockWidget(problems, dock);
        dock->show();
        QTimer::singleShot(0, dock, &QWidget::raise);  // deferred until the window shows the new document
    });
    QObject::connect(&document, &Document::replaced, dock, &QDockWidget::hide);
}

/// Reloading discards edits, so the button says so if there are any.
void tellChanged(NoticeBar& bar, Document& document, const QString& path) {
    const QString name = QFileInfo(path).fileName();
    const auto reload = [&document, path] {
        if (!document.open(path).empty()) document.openPart(path);
    };
    if (document.isModified())
        bar.say(QMainWindow::tr("%1 was changed on disk. You have unsaved edits.").arg(name),
                {{QMainWindow::tr("Discard my edits and reload"), reload}});
    else
        bar.say(QMainWindow::tr("%1 was changed on disk.").arg(name), {{QMainWindow::tr("Reload"), reload}});
}

}  // namespace

void addFileNotices(QMainWindow& window, Document& document, const Themes& themes) {
    assert(window.centralWidget());
    addReadingReport(window, document, themes);
    auto* bar = new NoticeBar(themes, window.centralWidget());
    auto* watch = new FileWatch(document, &window);
    QObject::connect(watch, &FileWatch::changedOnDisk, bar,
                     [bar, &document](const QString& path) { tellChanged(*bar, document, path); });
    QObject::connect(watch, &FileWatch::goneFromDisk, bar, [bar](const QString& path) {
        bar->say(QMainWindow::tr("%1 no longer exists: another program deleted or moved it. Saving creates it again.")
                     .arg(QFileInfo(path).fileName()), {});
    });
    QObject::connect(&document, &Document::replaced, bar, &QWidget::hide);
}

}  // namespace keyblock
