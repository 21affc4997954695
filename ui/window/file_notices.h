// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tells, without asking to be answered, of files that do not open cleanly and of
// those that another program has written meanwhile.
#pragma once

class QMainWindow;

namespace keyblock {

class Document;
class Themes;

/// \pre the window has its central widget.
void addFileNotices(QMainWindow& window, Document& document, const Themes& themes);

}  // namespace keyblock
