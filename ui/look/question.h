// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modal questions and messages with a uniform look: text and buttons, without the
// icons of another toolkit.
#pragma once

#include <QMessageBox>

namespace keyblock {

/// \param buttons the first in the list is the answer to Enter. \return the button that was pressed.
QMessageBox::StandardButton ask(QWidget& window, const QString& title, const QString& text, const QString& further,
                                const QList<QPair<QMessageBox::StandardButton, QString>>& buttons);

}  // namespace keyblock
