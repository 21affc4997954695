// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks for the path of a file to write. The desktop's dialog does not know the
// extension added afterwards, and would not ask before another file is overwritten.
#pragma once

#include <QString>

class QWidget;

namespace keyblock {

/// A path that ends with `.` and `ending`; empty: cancelled. `start` is the suggestion.
QString askSavePath(QWidget& window, const QString& title, const QString& start, const QString& filter,
                    const QString& ending);

}  // namespace keyblock
