// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_commands.h"

#include "solver/run/errors.h"
#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/edit/usual.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QUndoStack>
#include <QWidget>

namespace keyblock {

namespace {

QString text(const char* source) { return QCoreApplication::translate("FileCommands", source); }

bool saveTo(Document& document, const QString& path, QWidget& window) {
    try {
        document.save(path);
        return true;
    } catch (const CannotWrite& error) {
        QMessageBox::critical(&window, text("The scene was not saved"), QString::fromUtf8(error.what()));
        return false;
    }
}

bool saveAs(Document& document, QWidget& window) {
    const QString start = document.path().isEmpty() ? document.title() + ".json" : document.path();
    QString path = QFileDialog::getSaveFileName(&window, text("Save scene"), start, text("Scenes (*.json)"));
    if (path.isEmpty()) return false;
    if (!path.endsWith(".json")) path += ".json";
    return saveTo(document, path, window);
}

bool save(Document& document, QWidget& window) {
    return document.path().isEmpty() ? saveAs(document, window) : saveTo(document, document.path(), window);
}

void askAndOpen(Document& document, QWidget& window) {
    const QString path =
        QFileDialog::getOpenFileName(&window, text("Open scene"), document.path(), text("Scenes (*.json)"));
    if (!path.isEmpty()) openDocument(document, path, window);
}

}  // namespace

bool mayDiscard(Document& document, QWidget& window) {
    if (!document.isModified()) return true;
    QMessageBox box(QMessageBox::Question, text("Unsaved edits"),
                    text("%1 has edits that are not saved.").arg(document.title()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window);
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save(document, window));
}

void openDocument(Document& document, const QString& path, QWidget& window) {
    if (!mayDiscard(document, window)) return;
    const std::vector<Problem> problems = document.open(path);
    if (problems.empty()) return;
    QStringList lines;
    for (const Problem& problem : problems) lines << QString::fromStdString(oneLine(problem));
    QMessageBox box(QMessageBox::Warning, text("The scene was not opened"), lines.first(), QMessageBox::Ok, &window);
    if (lines.size() > 1) box.setDetailedText(lines.join('\n'));
    box.exec();
}

void addFileCommands(Commands& commands, Document& document, QWidget& window) {
    commands.add({"file.new", text("New scene"), "File", "new", text("Begins an empty scene."), {QKeySequence::New}},
                 [&] { if (mayDiscard(document, window)) document.startNew(newScene()); });
    commands.add({"file.open", text("Open…"), "File", "open", text("Opens a scene file."), {QKeySequence::Open}},
                 [&] { askAndOpen(document, window); });
    commands.add({"file.save", text("Save"), "File", "save", text("Writes the scene to its file."),
                  {QKeySequence::Save}, false, "save"},
                 [&] { save(document, window); });
    commands.add({"file.saveAs", text("Save as…"), "File", {}, text("Writes the scene to another file."),
                  {QKeySequence("Ctrl+Shift+S")}, false, "save"},
                 [&] { saveAs(document, window); });
    commands.add({"file.quit", text("Quit"), "File", {}, {}, {QKeySequence("Ctrl+Q")}, false, "quit"},
                 [&] { window.close(); });
}

void addEditCommands(Commands& commands, Document& document) {
    QUndoStack& undo = document.undo();
    QAction* back = commands.add({"edit.undo", text("Undo"), "Edit", "undo", {}, {QKeySequence::Undo}},
                                 [&] { undo.undo(); });
    QAction* again = commands.add({"edit.redo", text("Redo"), "Edit", "redo", {}, 
                                   {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")}},
                                  [&] { undo.redo(); });
    const auto name = [back, again, &undo] {
        back->setEnabled(undo.canUndo());
        again->setEnabled(undo.canRedo());
        back->setText(undo.canUndo() ? text("Undo: %1").arg(undo.undoText()) : text("Undo"));
        again->setText(undo.canRedo() ? text("Redo: %1").arg(undo.redoText()) : text("Redo"));
    };
    QObject::connect(&undo, &QUndoStack::indexChanged, &commands, name);
    QObject::connect(&undo, &QUndoStack::cleanChanged, &commands, name);
    name();
}

void addCanvasCommands(Commands& commands, Canvas& canvas) {
    const auto middle = [&canvas] { return QPointF(canvas.rect().center()); };
    commands.add({"view.fit", text("Fit"), "View", "fit", text("Shows what the section is about; again: all of it."),
                  {QKeySequence("F")}, false, "zoom"},
                 [&canvas] { canvas.fit(); });
    commands.add({"view.zoomIn", text("Zoom in"), "View", {}, {}, {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")},
                  false, "zoom"},
                 [&canvas, middle] { canvas.zoomBy(1.25, middle()); });
    commands.add({"view.zoomOut", text("Zoom out"), "View", {}, {}, {QKeySequence("Ctrl+-")}, false, "zoom"},
                 [&canvas, middle] { canvas.zoomBy(0.8, middle()); });
}

void addViewCommands(Commands& commands, Themes& themes, Display& display) {
    QAction* dark = commands.add({"view.dark", text("Dark theme"), "View", {}, {}, {}, true, "look"},
                                 [&] { themes.choose(!themes.isDark()); });
    dark->setChecked(themes.isDark());
    QObject::connect(&themes, &Themes::changed, dark, [dark, &themes] { dark->setChecked(themes.isDark()); });
    QAction* si = commands.add({"view.si", text("Plain SI units"), "View", {},
                                text("Shows N, Pa and J instead of kN, MPa and kJ."), {}, true, "look"},
                               [&display] {
                                   const bool plain = display.system() == UnitSystem::Si;
                                   display.setSystem(plain ? UnitSystem::Engineering : UnitSystem::Si);
                               });
    QAction* sign = commands.add({"view.compression", text("Compression positive"), "View", {}, {}, {}, true, "look"},
                                 [&display] { display.setCompressionPositive(!display.compressionPositive()); });
    const auto tell = [si, sign, &display] {
        si->setChecked(display.system() == UnitSystem::Si);
        sign->setChecked(display.compressionPositive());
    };
    QObject::connect(&display, &Display::changed, si, tell);
    tell();
}

}  // namespace keyblock
