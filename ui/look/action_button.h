// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A button that runs a command and is on when the command is. Unlike one that Qt
// makes of an action it keeps the icon and the words that its place gives it.
#pragma once

#include <QString>

#include <functional>

class QAbstractButton;
class QAction;
class QToolButton;
class QWidget;

namespace keyblock {

/// Lets a button follow the command: a click runs it, and it has the command's tooltip. `text` gives what stands on it,
/// asked again whenever the command changes; none: it stays as it is.
void follow(QAbstractButton& button, QAction& action, std::function<QString()> text = {});

/// A tool button that follows the command, with the command's id as its name.
QToolButton* buttonOf(QAction& action, QWidget* parent, std::function<QString()> text = {});

}  // namespace keyblock
