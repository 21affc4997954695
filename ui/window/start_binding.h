// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lets the start page open, recover and copy into the window's document.
#pragma once

#include "ui/start/start_page.h"

class QMainWindow;

namespace keyblock {

class Themes;

/// Creates the start page over the window, with its command. \pre the commands of its buttons have been added.
StartPage* addStartPage(QMainWindow& window, const StartPage::Rooms& rooms);

/// Start-up without a file: shows the start page if it is enabled or something can be recovered.
void beginWithStartPage(StartPage& page);

/// Start-up with a file, without the start page: a bar over `canvas` offers scenes that can be recovered.
void tellAbandoned(StartPage& page, const Themes& themes, QWidget* canvas);

}  // namespace keyblock
