// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Journals that nobody closed, and the way back from one to a document.
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
    QDateTime last;  // when the last was written
    QString damage;  // for people; empty: none
};

/// What can be recovered, newest first. Journals of windows that are open are left alone, those without anything to
/// recover are removed; what cannot be read at all is put aside under another name and told in `unusable`.
std::vector<Abandoned> abandonedJournals(const QString& folder = journalFolder(), QStringList* unusable = nullptr);

enum class Recover { Everything, WithoutLastCommand };

/// Makes the document what the journal tells, with its steps of undo; the old journal goes once `journal` holds all of
/// it. What keeps it from being recovered comes back; empty: nothing did.
QString recover(const Abandoned& abandoned, Recover what, Document& document, Journal& journal);

/// Gives its edits up.
void giveUp(const Abandoned& abandoned);

}  // namespace keyblock
