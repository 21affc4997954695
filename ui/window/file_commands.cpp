// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_commands.h"

#include "solver/run/write_error.h"
#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/file_folder.h"
#include "ui/edit/defaults.h"
#include "ui/look/ask_path.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/question.h"
#include "ui/look/theme.h"

#include <QFileDialog>
#include <QUndoStack>
#include <QWidget>

namespace keyblock {

namespace {

bool saveTo(Document& document, const QString& path, QWidget& window) {
    try {
        document.save(path);
        return true;
    } catch (const CannotWrite& error) {
        ask(window, QWidget::tr("Save scene"), QWidget::tr("The scene was not saved."), QString::fromUtf8(error.what()),
            {{QMessageBox::Ok, {}}});
        return false;
    }
}

bool saveAs(Document& document, QWidget& window) {
    const QString start = document.path().isEmpty() ? fileFolder(document) + '/' + document.title() + ".json" : document.path();
    const QString path = askSavePath(window, QWidget::tr("Save scene"), start, QWidget::tr("Scenes (*.json)"), "json");
    if (path.isEmpty() || !saveTo(document, path, window)) return false;
    rememberFolderOf(path);
    return true;
}

bool save(Document& document, QWidget& window) {
    return document.path().isEmpty() ? saveAs(document, window) : saveTo(document, document.path(), window);
}

QString askForFile(const Document& document, QWidget& window) {
    const QStringList filters{QWidget::tr("All supported files (*.json *.kbrun *.dxf *.DXF *.csv *.CSV)"),
                              QWidget::tr("Scenes (*.json)"), QWidget::tr("Runs (*.kbrun)"),
                              QWidget::tr("Drawings and joint or bolt lists (*.dxf *.DXF *.csv *.CSV)")};
    return QFileDialog::getOpenFileName(&window, QWidget::tr("Open"), fileFolder(document), filters.join(";;"));
}

/// Adds the command that reads the file again.
void addRevert(Commands& commands, Document& document, QWidget& window) {
    QAction* revert = commands.add(
        {"file.revert", QWidget::tr("Revert to saved"), "File", {}, QWidget::tr("Discards all edits since the last save."),
         {}, false, "save"},
        [&] {
            const auto answer = ask(window, QWidget::tr("Revert to saved"),
                                    QWidget::tr("Discard all edits to %1 since the last save?").arg(document.title()),
                                    {}, {{QMessageBox::Cancel, {}}, {QMessageBox::Discard, {}}});
            if (answer == QMessageBox::Discard) openDocument(document, document.path(), window, UnsavedEdits::Settled);
        });
    const auto enable = [revert, &document] {
        revert->setEnabled(!document.path().isEmpty() && document.isModified());
    };
    QObject::connect(&document, &Document::fileChanged, revert, enable);
    QObject::connect(&document.undo(), &QUndoStack::cleanChanged, revert, enable);
    enable();
}

}  // namespace

bool mayDiscard(Document& document, QWidget& window) {
    finishTyping();
    if (!document.isModified()) return true;
    const auto answer = ask(window, QWidget::tr("Unsaved edits"),
                            QWidget::tr("%1 has unsaved edits.").arg(document.title()), {},
                            {{QMessageBox::Save, {}}, {QMessageBox::Discard, {}}, {QMessageBox::Cancel, {}}});
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save(document, window));
}

void openDocument(Document& document, const QString& path, QWidget& window, UnsavedEdits edits) {
    if (edits == UnsavedEdits::Ask && !mayDiscard(document, window)) return;
    if (!document.open(path).empty()) document.openPart(path);
}

void addFileCommands(Commands& commands, Document& document, QWidget& window,
                     std::function<void(const QString&)> open) {
    commands.add({"file.new", QWidget::tr("New scene"), "File", "new", QWidget::tr("Starts an empty scene."), {QKeySequence::New}},
                 [&] { if (mayDiscard(document, window)) document.startNew(newScene()); });
    commands.add({"file.open", QWidget::tr("Open…"), "File", "open", QWidget::tr("Opens a scene, a run with its scene, or a drawing to import."), {QKeySequence::Open}},
                 [&document, &window, open = std::move(open)] {
                     if (!mayDiscard(document, window)) return;
                     const QString path = askForFile(document, window);
                     if (path.isEmpty()) return;
                     rememberFolderOf(path);
                     open(path);
                 });
    commands.add({"file.save", QWidget::tr("Save"), "File", "save", QWidget::tr("Saves the scene to its file."),
                  {QKeySequence::Save}, false, "save"},
                 [&] { save(document, window); });
    commands.add({"file.saveAs", QWidget::tr("Save as…"), "File", {}, QWidget::tr("Saves the scene to another file."),
                  {QKeySequence("Ctrl+Shift+S")}, false, "save"},
                 [&] { saveAs(document, window); });
    addRevert(commands, document, window);
    commands.add({"file.quit", QWidget::tr("Quit"), "File", {}, {}, {QKeySequence("Ctrl+Q")}, false, "quit"},
                 [&] { window.close(); });
}

void addEditCommands(Commands& commands, Document& document) {
    QUndoStack& undo = document.undo();
    QAction* back = commands.add({"edit.undo", QWidget::tr("Undo"), "Edit", "undo", {}, {QKeySequence::Undo}},
                                 [&] { undo.undo(); });
    QAction* again = commands.add({"edit.redo", QWidget::tr("Redo"), "Edit", "redo", {}, 
                                   {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")}},
                                  [&] { undo.redo(); });
    const auto name = [back, again, &undo] {
        back->setEnabled(undo.canUndo());
        again->setEnabled(undo.canRedo());
        back->setText(undo.canUndo() ? QWidget::tr("Undo: %1").arg(undo.undoText()) : QWidget::tr("Undo"));
        again->setText(undo.canRedo() ? QWidget::tr("Redo: %1").arg(undo.redoText()) : QWidget::tr("Redo"));
    };
    QObject::connect(&undo, &QUndoStack::indexChanged, &commands, name);
    QObject::connect(&undo, &QUndoStack::cleanChanged, &commands, name);
    name();
}

void addCanvasCommands(Commands& commands, Canvas& canvas) {
    const auto middle = [&canvas] { return QPointF(canvas.rect().center()); };
    commands.add({"view.fit", QWidget::tr("Fit"), "View", "fit", QWidget::tr("Zooms to the excavation; press again for the whole section."),
                  {QKeySequence("F")}, false, "zoom"},
                 [&canvas] { canvas.fit(); });
    commands.add({"view.zoomBox", QWidget::tr("Zoom window"), "View", "zoom-box",
                  QWidget::tr("Zooms to a rectangle that you draw."), {QKeySequence("Z")}, false, "zoom"},
                 [&canvas] { canvas.startZoomBox(); });
    commands.add({"view.zoomIn", QWidget::tr("Zoom in"), "View", {}, {}, {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")},
                  false, "zoom"},
                 [&canvas, middle] { canvas.zoomBy(1.25, middle()); });
    commands.add({"view.zoomOut", QWidget::tr("Zoom out"), "View", {}, {}, {QKeySequence("Ctrl+-")}, false, "zoom"},
                 [&canvas, middle] { canvas.zoomBy(0.8, middle()); });
}

void addViewCommands(Commands& commands, Themes& themes, Display& display) {
    QAction* dark = commands.add({"view.dark", QWidget::tr("Dark theme"), "View", {}, {}, {}, true, "look"},
                                 [&] { themes.choose(!themes.isDark()); });
    dark->setChecked(themes.isDark());
    QObject::connect(&themes, &Themes::changed, dark, [dark, &themes] { dark->setChecked(themes.isDark()); });
    QAction* si = commands.add({"view.si", QWidget::tr("SI units without prefixes"), "View", {},
                                QWidget::tr("Shows N, Pa and J instead of kN, MPa and kJ."), {}, true, "look"},
                               [&display] {
                                   const bool plain = display.system() == UnitSystem::Si;
                                   display.setSystem(plain ? UnitSystem::Engineering : UnitSystem::Si);
                               });
    QAction* sign = commands.add({"view.compression", QWidget::tr("Compression positive"), "View", {}, {}, {}, true, "look"},
                                 [&display] { display.setCompressionPositive(!display.compressionPositive()); });
    const auto tell = [si, sign, &display] {
        si->setChecked(display.system() == UnitSystem::Si);
        sign->setChecked(display.compressionPositive());
    };
    QObject::connect(&display, &Display::changed, si, tell);
    tell();
}

}  // namespace keyblock
