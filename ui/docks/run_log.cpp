// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/run_log.h"

#include "ui/look/theme.h"

#include <QTime>

namespace keyblock {

namespace {

constexpr int mostLines = 2000;

}  // namespace

RunLog::RunLog(const Themes& themes, QWidget* parent) : QPlainTextEdit(parent), themes_(themes) {
    setObjectName("runLog");
    setAccessibleName(tr("Log"));
    setReadOnly(true);
    setMaximumBlockCount(mostLines);
    setFrameShape(QFrame::NoFrame);
    setPlaceholderText(tr("Run messages appear here."));
}

void RunLog::tell(const QString& message, bool isError) {
    const QString time = QTime::currentTime().toString("hh:mm:ss");
    const QString line = QStringLiteral("%1  %2").arg(time, message.toHtmlEscaped());
    appendHtml(isError ? QStringLiteral("<span style=\"color:%1\">%2</span>").arg(themes_.current().error.name(), line)
                       : line);
}

}  // namespace keyblock
