// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/ask_path.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace keyblock {

QString askSavePath(QWidget& window, const QString& title, const QString& start, const QString& filter,
                    const QString& ending) {
    const QString typed = QFileDialog::getSaveFileName(&window, title, start, filter);
    if (typed.isEmpty() || typed.endsWith('.' + ending)) return typed;
    const QString path = typed + '.' + ending;
    if (!QFileInfo::exists(path)) return path;
    const auto answer = QMessageBox::question(
        &window, title, QWidget::tr("%1 is there already. Write over it?").arg(QFileInfo(path).fileName()));
    return answer == QMessageBox::Yes ? path : QString();
}

}  // namespace keyblock
