// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/ask_path.h"

#include "ui/look/question.h"

#include <QFileDialog>
#include <QFileInfo>

namespace keyblock {

QString askSavePath(QWidget& window, const QString& title, const QString& start, const QString& filter,
                    const QString& ending) {
    const QString typed = QFileDialog::getSaveFileName(&window, title, start, filter);
    if (typed.isEmpty() || typed.endsWith('.' + ending)) return typed;
    const QString path = typed + '.' + ending;
    if (!QFileInfo::exists(path)) return path;
    const auto answer = ask(window, title, QWidget::tr("%1 already exists.").arg(QFileInfo(path).fileName()), {},
                            {{QMessageBox::Cancel, {}}, {QMessageBox::Yes, QWidget::tr("Replace")}});
    return answer == QMessageBox::Yes ? path : QString();
}

}  // namespace keyblock
