// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/clipboard.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/tools/select_tool.h"

#include <QAction>

#include <algorithm>

namespace keyblock {
namespace {

constexpr double shift = 24.0;  // [px] distance of a copy from its original

/// True for an object in a list; other objects cannot be copied.
bool isOfList(const QString& pointer) { return pointer.count('/') > 1; }

/// The scene and its settings cannot be deleted.
bool mayGo(const QString& pointer) { return !pointer.isEmpty() && pointer != "/analysis"; }

}  // namespace

Clipboard::Clipboard(Workbench& bench, SelectTool& select, Commands& commands, QObject* parent)
    : QObject(parent), bench_(bench), select_(select) {
    const auto add = [&](const char* id, const QString& text, const char* icon, const QString& help,
                         const QKeySequence& key, void (Clipboard::*run)()) {
        const QString group = QString(id) == "edit.selectAll" ? "select" : "clipboard";
        return commands.add({id, text, "Edit", icon, help, {key}, false, group}, [this, run] { (this->*run)(); });
    };
    copying_ = {
        add("edit.cut", tr("Cut"), "", tr("Moves the selection to the clipboard."), QKeySequence::Cut,
            &Clipboard::cut),
        add("edit.copy", tr("Copy"), "copy", tr("Copies the selection to the clipboard."), QKeySequence::Copy,
            &Clipboard::copy)};
    paste_ = add("edit.paste", tr("Paste"), "", tr("Adds the copied objects, with new names."), QKeySequence::Paste,
                 &Clipboard::paste);
    copying_ << add("edit.duplicate", tr("Duplicate"), "", tr("Adds a copy next to the selection."),
                    QKeySequence("Ctrl+D"), &Clipboard::duplicate);
    delete_ = add("edit.delete", tr("Delete"), "delete",
                  tr("Deletes the selection and the objects that depend on it."), QKeySequence::Delete,
                  &Clipboard::remove);
    all_ = add("edit.selectAll", tr("Select all"), "", tr("Selects all objects in the section that are not locked."),
               QKeySequence::SelectAll, &Clipboard::selectAll);
    connect(&bench.selection(), &Selection::changed, this, &Clipboard::showWhatCan);
    connect(&bench.document(), &Document::changed, this, &Clipboard::showWhatCan);
    connect(&bench, &Workbench::drawingChanged, this, &Clipboard::showWhatCan);
    showWhatCan();
}

/// While results are shown, nothing can be added to the scene or deleted from it.
void Clipboard::showWhatCan() {
    const bool drawing = bench_.isDrawing();
    const QStringList& chosen = bench_.selection().pointers();
    const bool copies = std::any_of(chosen.begin(), chosen.end(), isOfList);
    const bool deletes = std::any_of(chosen.begin(), chosen.end(), mayGo);
    for (QAction* action : copying_) action->setEnabled(drawing && copies);
    delete_->setEnabled(drawing && deletes);
    paste_->setEnabled(drawing && source_);
    all_->setEnabled(drawing && !bench_.objects().empty());
}

void Clipboard::cut() {
    copy();
    remove();
}

void Clipboard::remove() { select_.removeSelected(); }

void Clipboard::selectAll() {
    QStringList all;
    for (const SceneObject& object : bench_.objects())
        if (!bench_.isLocked(object.pointer)) all << QString::fromStdString(object.pointer);
    bench_.selection().set(all);
}

void Clipboard::copy() {
    source_ = bench_.document().committed();
    pointers_ = bench_.selection().pointers();
    pasted_ = 0;
    showWhatCan();
}

void Clipboard::paste() { put(*source_, pointers_, tr("Paste"), shift * ++pasted_); }

void Clipboard::duplicate() { put(bench_.scene(), bench_.selection().pointers(), tr("Duplicate"), shift); }

void Clipboard::put(const Scene& source, const QStringList& pointers, const QString& step, double pixels) {
    std::vector<std::string> from, made;
    for (const QString& pointer : pointers) from.push_back(pointer.toStdString());
    const double off = bench_.metres(pixels);
    const Edit edit = copyAll(bench_.scene(), source, from, {off, -off}, made);
    if (!bench_.commit(step, edit)) return;
    QStringList chosen;
    for (const std::string& pointer : made) chosen << QString::fromStdString(pointer);
    bench_.selection().set(chosen);
}

}  // namespace keyblock
