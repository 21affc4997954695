// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A button that runs a command and is enabled with it. Unlike Qt's own button of an
// action it can have its own icon and text.
#pragma once

#include <QString>

#include <functional>

class QAbstractButton;
class QAction;
class QToolButton;
class QWidget;

namespace keyblock {

/// Connects a button to the command: a click runs it, and it has the command's tooltip. `text` returns its label and is
/// called again whenever the command changes; none: the label is kept.
void follow(QAbstractButton& button, QAction& action, std::function<QString()> text = {});

/// A tool button connected to the command, with the command's id as its name.
QToolButton* buttonOf(QAction& action, QWidget* parent, std::function<QString()> text = {});

}  // namespace keyblock
