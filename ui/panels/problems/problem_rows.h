// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rows of the Problems panel: the messages of the check and the cut report.
#pragma once

#include "ui/panels/problems/problem_remedies.h"

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
    QString link;  // label of the link: fix, show or open
    std::optional<Remedy> remedy;
    QString pointer;  // pointer to the object or field concerned; empty: the whole section
    std::optional<Box> box;  // location of the problem [m]
    bool opensReport = false;
    int depth = 0;
};

/// Rows for errors, warnings and notes of the latest check, then for slivers and the cut report. If the report is open,
/// its notes follow.
std::vector<ProblemRow> problemRows(const Document& document, const Display& display, bool reportIsOpen);

/// Number of errors and warnings in `rows`.
int urgentCount(const std::vector<ProblemRow>& rows);

}  // namespace keyblock
