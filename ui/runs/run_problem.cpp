// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_problem.h"

#include "ui/document/document.h"

#include <QCoreApplication>

namespace keyblock {

QString firstError(const std::vector<Problem>& problems) {
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error) return QString::fromStdString(problem.message + ". " + problem.remedy);
    return {};
}

QString runProblem(const Document& document) {
    if (!document.checkIsCurrent())
        return QCoreApplication::translate("Runs", "The scene is still being checked. Try again.");
    if (const QString error = firstError(document.checked().problems); !error.isEmpty()) return error;
    return document.committed()->stages.empty() ? QCoreApplication::translate("Runs", "Nothing to run: add a stage.")
                                                : QString();
}

}  // namespace keyblock
