// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the check and the cut have to say, row by row as people read it.
#pragma once

#include "ui/panels/problem_remedies.h"

#include <QString>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace keyblock {

class Display;
class Document;

struct ProblemRow {
    enum class Sign { Error, Warning, Note, Report };

    Sign sign = Sign::Note;
    QString title, detail, where;
    QString link;  // what a click on it does: mend, show, open
    std::optional<Remedy> remedy;
    QString pointer;  // of what it is about, down to the field; empty: the whole section
    std::optional<Box> box;  // where it lies [m]
    int opens = -1;  // kind of notes that the row stands for, as CutNoteKind; `allNotes`: the report
    int depth = 0;
};

inline constexpr int allNotes = 100;

/// Errors, warnings and notes of the newest check, then slivers and the report of the cut. Notes of a kind that is in
/// `open` follow their row, one each.
std::vector<ProblemRow> problemRows(const Document& document, const Display& display, const std::set<int>& open);

/// Of these, errors and warnings.
int urgentCount(const std::vector<ProblemRow>& rows);

}  // namespace keyblock
