// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/run_warning.h"

#include "solver/results/verdict.h"
#include "ui/look/theme.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QStringList>

namespace keyblock {

RunWarning::RunWarning(const Themes& themes, const TimeCursor& cursor, QWidget* parent)
    : ElidedLabel(parent), themes_(themes), cursor_(cursor) {
    setObjectName("runWarning");
    setAccessibleName(tr("Warning about the results of this stage"));
    setContentsMargins(12, 3, 12, 3);
    for (const auto signal : {&TimeCursor::runChanged, &TimeCursor::runGrew, &TimeCursor::moved})
        connect(&cursor, signal, this, &RunWarning::refresh);
    connect(&themes, &Themes::changed, this, &RunWarning::showTheme);
    showTheme();
    refresh();
}

void RunWarning::setOn(bool on) {
    on_ = on;
    refresh();
}

void RunWarning::setNotFinite(const std::string& text) {
    notFinite_ = QString::fromStdString(text);
    refresh();
}

void RunWarning::refresh() {
    QStringList texts;
    if (on_ && cursor_.hasMoment()) {
        const int stage = cursor_.head().stage;
        for (const StageWarning& warning : stageWarnings(*cursor_.run()))
            if (warning.stage == stage || warning.stage < 0) texts += QString::fromStdString(warning.text);
    }
    if (on_ && !notFinite_.isEmpty()) texts += notFinite_;
    setText(texts.isEmpty() ? QString() : tr("Warning: %1.").arg(texts.join("; ")));
    setVisible(!texts.isEmpty());
}

void RunWarning::showTheme() {
    const Theme& theme = themes_.current();
    setStyleSheet(QStringLiteral("background: %1; color: %2;").arg(theme.warningSoft.name(), theme.text.name()));
}

}  // namespace keyblock
