// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/report_binding.h"

#include "ui/export/report_window.h"
#include "ui/look/commands.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QStandardPaths>

namespace keyblock {

namespace {

/// The path of the report next to its run, or in the documents if the run is in the program's own data folder.
std::filesystem::path suggestedReport(const std::filesystem::path& store) {
    const QString own = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    const QString folder = QString::fromStdString(store.parent_path().string());
    const bool isOwn = QDir::cleanPath(folder).startsWith(QDir::cleanPath(own));
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString place = !isOwn ? folder : QDir(documents).exists() ? documents : QDir::homePath();
    return std::filesystem::path(place.toStdString()) / store.stem();
}

}  // namespace

ReportWindow* addReportCommand(QMainWindow& window, Commands& commands, const TimeCursor& cursor) {
    auto* report = new ReportWindow(&window);
    commands.add({"file.report",
                  QMainWindow::tr("Report…"),
                  "File",
                  {},
                  QMainWindow::tr("Makes a report of the run as PDF or HTML, with figures and tables."),
                  {},
                  false,
                  "save"},
                 [report, &cursor] {
                     if (!cursor.run()) return;
                     const std::filesystem::path store = cursor.run()->store();
                     report->open({store, ReportKind::Run, suggestedReport(store)});
                 });
    const auto enable = [&commands, &cursor] {
        commands.setWhyNot("file.report",
                           cursor.run() ? QString() : QMainWindow::tr("No results yet. Run the scene first."));
    };
    QObject::connect(&cursor, &TimeCursor::runChanged, report, enable);
    enable();
    return report;
}

}  // namespace keyblock
