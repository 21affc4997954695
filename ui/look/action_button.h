// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A button that runs a command and is enabled together with it. Unlike Qt's own button
// for an action, it can have its own icon and text.
#pragma once

#include <QString>

#include <functional>

class QAbstractButton;
class QAction;
class QToolButton;
class QWidget;

namespace keyblock {

/// Connects a button to a command: a click runs the command, and the button shows the tooltip of the command.
/// \param text returns the label and is called whenever the command changes; null: the label is not changed.
void follow(QAbstractButton& button, QAction& action, std::function<QString()> text = {});

/// Creates a tool button connected to the command, with the id of the command as its object name.
QToolButton* buttonOf(QAction& action, QWidget* parent, std::function<QString()> text = {});

}  // namespace keyblock
