// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Asks for the path of a file to write. The desktop's dialog does not know about an
// extension that is added afterwards, so it would not ask before an existing file is
// overwritten.
#pragma once

#include <QString>

class QWidget;

namespace keyblock {

/// Asks for a path with the extension `ending`, given without a dot; returns an empty path if the user cancels.
/// \param start the suggested path.
QString askSavePath(QWidget& window, const QString& title, const QString& start, const QString& filter,
                    const QString& ending);

}  // namespace keyblock
