// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lets the first page open, recover and copy into the window's document.
#pragma once

#include "ui/start/start_page.h"

class QMainWindow;

namespace keyblock {

class Themes;

/// Makes the first page over the window, with its command. \pre the commands that it has buttons for are there.
StartPage* addStartPage(QMainWindow& window, const StartPage::Rooms& rooms);

/// What a window without a file begins with: the first page, where it is wanted or something can be recovered.
void beginWithStartPage(StartPage& page);

/// Tells over `canvas` what an earlier window left behind, where one that opens a file shows no first page.
void tellAbandoned(StartPage& page, const Themes& themes, QWidget* canvas);

}  // namespace keyblock
