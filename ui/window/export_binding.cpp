// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/export_binding.h"

#include "ui/canvas/canvas.h"
#include "ui/export/export_window.h"
#include "ui/figure/figure.h"
#include "ui/look/commands.h"
#include "ui/picture/section/arrows.h"
#include "ui/picture/section/contact_lines.h"
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
    return std::string(view.blocks ? view.blocks->name : plainWord);
}

Exportable shownNow(const TimeCursor& cursor, const BoltChoice& choice, const ViewSettings& view, const Canvas& canvas) {
    Exportable shown;
    if (!cursor.run()) return shown;
    shown.run = cursor.run();
    shown.store = cursor.run()->store();
    shown.frame = cursor.frame();
    shown.bolt = choice.bolt();
    shown.quantity = quantityOf(view.choice());
    shown.boltQuantity = std::string(view.choice().bolts ? view.choice().bolts->name : plainWord);
    shown.factor = view.choice().factor;
    shown.scales = view.choice().scales;
    shown.view = canvas.map().window();
    return shown;
}

}  // namespace

void addExportCommands(QMainWindow& window, Commands& commands, const Themes& themes, const TimeCursor& cursor,
                       const BoltChoice& choice, const ViewSettings& view, const Canvas& canvas) {
    auto* exporting = new ExportWindow([&] { return shownNow(cursor, choice, view, canvas); }, themes, &window);
    const auto add = [&](const char* id, const QString& text, const QString& help, ExportWhat what) {
        commands.add({id, text, "Results", "export", help, {}, false, "export"}, [exporting, what] { exporting->open(what); });
    };
    add("export.figure", QMainWindow::tr("Export figure…"),
        QMainWindow::tr("Exports the section, a bolt diagram, curves or events as SVG, PDF or PNG."),
        ExportWhat::Figure);
    add("export.table", QMainWindow::tr("Export table…"), QMainWindow::tr("Exports results of the run as CSV."), ExportWhat::Numbers);
    add("export.film", QMainWindow::tr("Export animation…"),
        QMainWindow::tr("Exports all frames as an MP4 or WebM video or as PNG images."), ExportWhat::Film);
    add("export.all", QMainWindow::tr("Export all…"), QMainWindow::tr("Exports all figures and tables to a folder."),
        ExportWhat::Everything);
    const auto enable = [&commands, &cursor] {
        const QString why = cursor.run() ? QString() : QMainWindow::tr("No results yet. Run the scene first.");
        for (const char* id : {"export.figure", "export.table", "export.film", "export.all"}) commands.setWhyNot(id, why);
    };
    QObject::connect(&cursor, &TimeCursor::runChanged, exporting, enable);
    for (const auto signal : {&TimeCursor::runChanged, &TimeCursor::runGrew, &TimeCursor::changed})
        QObject::connect(&cursor, signal, exporting, [exporting, &cursor] {
            if (!cursor.goesOn()) exporting->refresh();
        });
    enable();
}

}  // namespace keyblock
