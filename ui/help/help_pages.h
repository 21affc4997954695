// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help pages built into the program, and a text search in them.
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace keyblock {

struct HelpPage {
    QString name;  // file name without .md
    QString title;  // its first heading
    QString text;  // as Markdown
};

/// All pages: first the page about the window, then the others sorted by name.
const std::vector<HelpPage>& helpPages();

/// The page with this name; null if there is none.
const HelpPage* findHelpPage(const QString& name);

struct HelpHit {
    const HelpPage* page = nullptr;
    QString heading;  // heading above the line
    QString line;  // the line without Markdown markup
    int occurrence = 0;  // index of the occurrence on the page, from 0
};

/// Lines that contain the typed text, headings first. Returns at most `most` lines.
std::vector<HelpHit> searchHelp(const QString& typed, std::size_t most = 60);

}  // namespace keyblock
