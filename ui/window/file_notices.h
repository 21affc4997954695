// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Notices, shown without a dialog, about files that could only be read in part and
// files that another program has changed.
#pragma once

class QMainWindow;

namespace keyblock {

class Document;
class Themes;

/// Adds the bar that reports changes of the scene file on disk, and the dock that lists the errors of a file of which
/// only a part could be read. \pre the central widget of the window has been set.
void addFileNotices(QMainWindow& window, Document& document, const Themes& themes);

}  // namespace keyblock
