// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Menu entries for controls that do not fit on a bar.
#pragma once

class QMenu;
class QWidget;

namespace keyblock {

/// Adds a control to the menu: a combo box as a submenu of its choices, a tool button as a single entry. Other widgets
/// are ignored. The menu must not outlive the control.
void addToMenu(QMenu& menu, QWidget& control);

}  // namespace keyblock
