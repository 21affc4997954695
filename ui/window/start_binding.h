// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connects the start page with the document of the window: opening scenes, recovering
// them and copying samples.
#pragma once

#include "ui/start/start_page.h"

class QMainWindow;

namespace keyblock {

class Themes;

/// Creates the start page over the window and adds its command. \pre the commands of its buttons have been added.
StartPage* addStartPage(QMainWindow& window, const StartPage::Rooms& rooms);

/// Start-up without a file: shows the start page unless the user has disabled it; shows it in any case if a scene can
/// be recovered.
void beginWithStartPage(StartPage& page);

/// Start-up with a file: the start page is not shown; if scenes can be recovered, a bar over `canvas` says so and
/// offers to open the start page.
void tellAbandoned(StartPage& page, const Themes& themes, QWidget* canvas);

}  // namespace keyblock
