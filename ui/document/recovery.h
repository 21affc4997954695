// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds journals that were not closed and recovers their documents.
#pragma once

#include "ui/document/journal.h"

#include <QDateTime>
#include <QString>

#include <cstddef>
#include <vector>

namespace keyblock {

class Document;

/// A journal whose program ended without closing it.
struct Abandoned {
    QString journal;  // file
    QString path;  // of the scene; empty: never saved
    QString title;
    std::size_t changes = 0;  // edits, undos and redos
    QString lastStep;
    QDateTime last;  // time of the last edit
    QString damage;  // message for the user; empty: none
};

/// Documents that can be recovered, newest first. Journals of open windows are skipped, those without anything to
/// recover are removed; unreadable ones are renamed and listed in `unusable`.
std::vector<Abandoned> abandonedJournals(const QString& folder = journalFolder(), QStringList* unusable = nullptr);

enum class Recover { Everything, WithoutLastCommand };

/// Restores the document with its undo steps from the journal; the old journal is removed once `journal` has all of
/// it. Returns why it cannot be recovered; empty: it was.
QString recover(const Abandoned& abandoned, Recover what, Document& document, Journal& journal);

/// Discards its edits.
void giveUp(const Abandoned& abandoned);

}  // namespace keyblock
