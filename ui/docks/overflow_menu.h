// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Menu entries for controls that do not fit on a bar.
#pragma once

class QMenu;
class QWidget;

namespace keyblock {

/// Adds an entry for the control: a submenu of choices for a combo box, one entry for a button. Other widgets are
/// ignored. The menu must not outlive the control.
void addToMenu(QMenu& menu, QWidget& control);

}  // namespace keyblock
