// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the Problems panel: messages of the check and the report of the cut.
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
    QString link;  // what a click on it does: fix, show, open
    std::optional<Remedy> remedy;
    QString pointer;  // of the object or field concerned; empty: the whole section
    std::optional<Box> box;  // its location [m]
    bool opensReport = false;
    int depth = 0;
};

/// Errors, warnings and notes of the newest check, then slivers and the cut report; if the report is open, its
/// notes follow.
std::vector<ProblemRow> problemRows(const Document& document, const Display& display, bool reportIsOpen);

/// Number of errors and warnings among them.
int urgentCount(const std::vector<ProblemRow>& rows);

}  // namespace keyblock
