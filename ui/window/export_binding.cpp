// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/export_binding.h"

#include "ui/export/export_window.h"
#include "ui/look/commands.h"
#include "ui/picture/arrows.h"
#include "ui/picture/contact_lines.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"
#include "ui/runs/view_settings.h"

#include <QMainWindow>

namespace keyblock {

namespace {

std::string quantityOf(const ViewChoice& view) {
    if (view.contacts) return std::string(contactWord);
    if (view.arrows) return std::string(arrowWords()[static_cast<std::size_t>(*view.arrows)]);
    return view.blocks ? std::string(view.blocks->name) : std::string();
}

Exportable shownNow(const TimeCursor& cursor, const BoltChoice& choice, const ViewSettings& view) {
    Exportable shown;
    if (!cursor.run()) return shown;
    shown.run = cursor.run();
    shown.store = cursor.run()->store();
    shown.frame = cursor.frame();
    shown.bolt = choice.bolt();
    shown.quantity = quantityOf(view.choice());
    shown.factor = view.choice().factor;
    shown.scales = view.choice().scales;
    return shown;
}

}  // namespace

void addExportCommands(QMainWindow& window, Commands& commands, const Themes& themes, const TimeCursor& cursor,
                       const BoltChoice& choice, const ViewSettings& view) {
    auto* exporting =
        new ExportWindow([&cursor, &choice, &view] { return shownNow(cursor, choice, view); }, themes, &window);
    const auto add = [&](const char* id, const QString& text, const QString& help, ExportWhat what) {
        commands.add({id, text, "Results", "export", help, {}, false, "export"}, [exporting, what] { exporting->open(what); });
    };
    add("export.figure", QMainWindow::tr("Export figure…"), QMainWindow::tr("The section, a bolt, curves or events as SVG, PDF or PNG."),
        ExportWhat::Figure);
    add("export.table", QMainWindow::tr("Export table…"), QMainWindow::tr("Numbers of the run as CSV."), ExportWhat::Numbers);
    add("export.film", QMainWindow::tr("Export film…"), QMainWindow::tr("All frames as MP4 or WebM."), ExportWhat::Film);
    add("export.all", QMainWindow::tr("Export everything…"), QMainWindow::tr("All figures and tables into a folder."), ExportWhat::Everything);
    const auto enable = [&commands, &cursor] {
        const QString why = cursor.run() ? QString() : QMainWindow::tr("There is no run yet; run the scene first.");
        for (const char* id : {"export.figure", "export.table", "export.film", "export.all"}) commands.setWhyNot(id, why);
    };
    QObject::connect(&cursor, &TimeCursor::runChanged, exporting, enable);
    enable();
}

}  // namespace keyblock
