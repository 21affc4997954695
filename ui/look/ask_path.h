// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks where to write a file. The dialog of the desktop knows nothing of the ending
// that a name gets afterwards, and would let it write over another file unasked.
#pragma once

#include <QString>

class QWidget;

namespace keyblock {

/// A path that ends with `.` and `ending`; empty: a person thought better of it. `start` is what is offered.
QString askSavePath(QWidget& window, const QString& title, const QString& start, const QString& filter,
                    const QString& ending);

}  // namespace keyblock
