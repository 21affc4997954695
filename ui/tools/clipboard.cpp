// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/clipboard.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/tools/select_tool.h"

namespace keyblock {
namespace {

constexpr double shift = 24.0;  // [px] that a copy lies off its original

}  // namespace

Clipboard::Clipboard(Workbench& bench, SelectTool& select, Commands& commands, QObject* parent)
    : QObject(parent), bench_(bench), select_(select) {
    const QString group = "clipboard";
    commands.add({"edit.cut", tr("Cut"), "Edit", {}, tr("Takes out what is selected, to be pasted."), {QKeySequence::Cut},
                  false, group}, [this] { copy(), select_.removeSelected(); });
    commands.add({"edit.copy", tr("Copy"), "Edit", "copy", tr("Keeps what is selected, to be pasted."),
                  {QKeySequence::Copy}, false, group}, [this] { copy(); });
    commands.add({"edit.paste", tr("Paste"), "Edit", {}, tr("Adds what was copied, under free names."),
                  {QKeySequence::Paste}, false, group}, [this] { paste(); });
    commands.add({"edit.duplicate", tr("Duplicate"), "Edit", {}, tr("Adds a copy beside what is selected."),
                  {QKeySequence("Ctrl+D")}, false, group}, [this] { duplicate(); });
    commands.add({"edit.delete", tr("Delete"), "Edit", "delete",
                  tr("Takes out what is selected, and what means nothing without it."), {QKeySequence::Delete}, false,
                  group}, [this] { select_.removeSelected(); });
    commands.add({"edit.selectAll", tr("Select all"), "Edit", {}, tr("Selects everything on the section."),
                  {QKeySequence::SelectAll}, false, "select"}, [this] {
        QStringList all;
        for (const SceneObject& object : bench_.objects()) all << QString::fromStdString(object.pointer);
        bench_.selection().set(all);
    });
}

void Clipboard::copy() {
    if (bench_.selection().isEmpty()) return;
    source_ = bench_.document().committed();
    pointers_ = bench_.selection().pointers();
    pasted_ = 0;
}

void Clipboard::paste() {
    if (!source_) return bench_.say(tr("Nothing was copied yet."));
    put(*source_, pointers_, tr("Paste"), shift * ++pasted_);
}

void Clipboard::duplicate() {
    if (!bench_.selection().isEmpty()) put(bench_.scene(), bench_.selection().pointers(), tr("Duplicate"), shift);
}

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
