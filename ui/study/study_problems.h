// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The problems of a study by the field at which they are shown.
#pragma once

#include "solver/scene/problem.h"

#include <QString>

#include <string>
#include <vector>

namespace keyblock {

struct FieldProblems {
    QString text;  // one line for each problem; empty: none
    bool isError = false;
};

/// Errors and warnings at a pointer. \param within also those of what lies below it
FieldProblems problemsAt(const std::vector<Problem>& problems, const std::string& pointer, bool within = false);

/// Number of errors.
int errorsIn(const std::vector<Problem>& problems);

/// A problem in one sentence with its remedy, without file and line.
QString sentenceOf(const Problem& problem);

}  // namespace keyblock
