// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/import_binding.h"

#include "ui/document/document.h"
#include "ui/document/file_folder.h"
#include "ui/edit/run_setup.h"
#include "ui/edit/defaults.h"
#include "ui/look/commands.h"
#include "ui/start/import_window.h"
#include "ui/window/file_commands.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>

namespace keyblock {

namespace {

void addImport(QMainWindow& window, Commands& commands, Document& document, const Themes& themes,
               const CommandText& text, const QString& filter) {
    commands.add(text, [&window, &document, &themes, filter] {
        const QString path = QFileDialog::getOpenFileName(&window, QMainWindow::tr("Import file"), fileFolder(document),
                                                          filter);
        if (path.isEmpty()) return;
        rememberFolderOf(path);
        openImport(window, document, themes, path);
    });
}

}  // namespace

void addImportCommands(QMainWindow& window, Commands& commands, Document& document, const Themes& themes) {
    addImport(window, commands, document, themes,
              {"file.importDxf", QMainWindow::tr("Import DXF…"), "File", "import", QMainWindow::tr("Creates a scene from a drawing, layer by layer."),
               {}},
              QMainWindow::tr("Drawings (*.dxf *.DXF)"));
    addImport(window, commands, document, themes,
              {"file.importCsv", QMainWindow::tr("Import CSV…"), "File", "import", QMainWindow::tr("Creates a scene from a list of joints or bolts."),
               {}},
              QMainWindow::tr("Joint or bolt lists (*.csv *.CSV)"));
}

bool isDrawing(const QString& path) {
    const QString ending = QFileInfo(path).suffix().toLower();
    return ending == "dxf" || ending == "csv";
}

void openImport(QMainWindow& window, Document& document, const Themes& themes, const QString& path) {
    auto* import = new ImportWindow(path, themes, &window);
    QObject::connect(import, &ImportWindow::imported, &window,
                     [&window, &document, import](const Scene& scene, const QString& name) {
                         if (!mayDiscard(document, window)) return;
                         document.startNew(newScene(), name);
                         document.apply(QMainWindow::tr("Import %1").arg(name), withRunSetup(scene));
                         import->close();
                     });
    import->show();
}

}  // namespace keyblock
