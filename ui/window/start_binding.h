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

/// Creates the start page, which covers the window, and adds the command that shows it.
/// \pre the commands that the buttons of the page run have been added.
StartPage* addStartPage(QMainWindow& window, const StartPage::Rooms& rooms);

/// To be called at start-up without a file. Shows the start page if the user has not disabled it, or if a scene can be
/// recovered.
void beginWithStartPage(StartPage& page);

/// To be called at start-up with a file. Does not show the start page. If scenes can be recovered, a bar over `canvas`
/// says so and offers to open the start page.
void tellAbandoned(StartPage& page, const Themes& themes, QWidget* canvas);

}  // namespace keyblock
