// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_problems.h"

#include "solver/scene/pointer.h"
#include "ui/look/qt_text.h"

#include <QStringList>

#include <algorithm>

namespace keyblock {

QString sentenceOf(const Problem& problem) {
    QString text = qt(problem.message);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return problem.remedy.empty() ? text : text + ". " + qt(problem.remedy);
}

FieldProblems problemsAt(const std::vector<Problem>& problems, const std::string& pointer, bool within) {
    FieldProblems found;
    QStringList lines;
    for (const Problem& problem : problems) {
        const bool isHere = within ? isWithin(problem.pointer, pointer) : problem.pointer == pointer;
        if (!isHere || problem.severity == Severity::Note) continue;
        found.isError = found.isError || problem.severity == Severity::Error;
        lines << sentenceOf(problem);
    }
    lines.removeDuplicates();
    found.text = lines.join('\n');
    return found;
}

int errorsIn(const std::vector<Problem>& problems) {
    return static_cast<int>(std::count_if(problems.begin(), problems.end(),
                                          [](const Problem& problem) { return problem.severity == Severity::Error; }));
}

}  // namespace keyblock
