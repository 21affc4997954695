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

/// \pre the central widget of the window has been set.
void addFileNotices(QMainWindow& window, Document& document, const Themes& themes);

}  // namespace keyblock
