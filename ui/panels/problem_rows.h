// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the check and the cut have to say, row by row as people read it.
#pragma once

#include "ui/panels/problem_remedies.h"

#include <QString>

#include <optional>
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
    bool opensReport = false;
    int depth = 0;
};

/// Errors, warnings and notes of the newest check, then slivers and the report of the cut; where that is open, its
/// notes follow one by one.
std::vector<ProblemRow> problemRows(const Document& document, const Display& display, bool reportIsOpen);

/// Of these, errors and warnings.
int urgentCount(const std::vector<ProblemRow>& rows);

}  // namespace keyblock
