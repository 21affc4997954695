// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Controls that do not fit on a bar, as entries of a menu.
#pragma once

class QMenu;
class QWidget;

namespace keyblock {

/// Adds the control: a list box becomes a submenu of its choices, a button an entry. Other widgets are left out. The
/// menu must not outlive the control.
void addToMenu(QMenu& menu, QWidget& control);

}  // namespace keyblock
