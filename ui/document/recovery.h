// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds journals that were not closed and recovers documents from them.
#pragma once

#include "ui/document/journal.h"

#include <QDateTime>
#include <QString>

#include <cstddef>
#include <vector>

namespace keyblock {

class Document;

/// A journal that was not closed, because the program ended unexpectedly.
struct Abandoned {
    QString journal;  // path of the journal file
    QString path;  // path of the scene file; empty: never saved
    QString title;
    std::size_t changes = 0;  // number of edits, undos and redos
    QString lastStep;
    QDateTime last;  // time of the last edit
    QString damage;  // error message; empty: no damage
};

/// Documents that can be recovered, latest first. Journals of open windows are skipped, and journals with nothing to
/// recover are deleted. Journals that cannot be read or used are listed in `unusable`. Those that are too damaged to be
/// used are also renamed to `….damaged`.
std::vector<Abandoned> abandonedJournals(const QString& folder = journalFolder(), QStringList* unusable = nullptr);

enum class Recover { Everything, WithoutLastCommand };

/// Restores a document with its undo steps. The old journal is removed once `journal` has stored all of its contents.
/// \return the reason why the document cannot be recovered; empty if it was recovered.
QString recover(const Abandoned& abandoned, Recover what, Document& document, Journal& journal);

/// Deletes this journal with the edits recorded in it.
void giveUp(const Abandoned& abandoned);

}  // namespace keyblock
