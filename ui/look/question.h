// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modal questions and messages in a uniform style: text and buttons, without icons of
// other toolkits.
#pragma once

#include <QMessageBox>

namespace keyblock {

/// Asks a question and waits for the answer.
/// \param further details shown below the text; may be empty.
/// \param buttons buttons with their labels (empty: Qt's label); Enter presses the first one.
/// \return the button that was pressed.
QMessageBox::StandardButton ask(QWidget& window, const QString& title, const QString& text, const QString& further,
                                const QList<QPair<QMessageBox::StandardButton, QString>>& buttons);

}  // namespace keyblock
