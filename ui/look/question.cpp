// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/question.h"

#include <QLabel>
#include <QPushButton>

namespace keyblock {

QMessageBox::StandardButton ask(QWidget& window, const QString& title, const QString& text, const QString& further,
                                const QList<QPair<QMessageBox::StandardButton, QString>>& buttons) {
    QMessageBox box(QMessageBox::NoIcon, title, text, QMessageBox::NoButton, &window);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(further);
    for (QLabel* label : box.findChildren<QLabel*>()) label->setTextFormat(Qt::PlainText);
    for (const auto& [button, words] : buttons) {
        QPushButton* made = box.addButton(button);
        if (!words.isEmpty()) made->setText(words);
        if (button == buttons.front().first) box.setDefaultButton(made);
    }
    return static_cast<QMessageBox::StandardButton>(box.exec());
}

}  // namespace keyblock
