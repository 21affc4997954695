// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help pages built into the program, and a search for words in them.
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace keyblock {

struct HelpPage {
    QString name;  // of its file, without .md
    QString title;  // its first heading
    QString text;  // in Markdown
};

/// All pages: the one on the window first, then by name.
const std::vector<HelpPage>& helpPages();

/// The page of that name; null if there is none.
const HelpPage* findHelpPage(const QString& name);

struct HelpHit {
    const HelpPage* page = nullptr;
    QString heading;  // heading above the line
    QString line;  // without Markdown marks
    int occurrence = 0;  // number of the hit in the page, from 0
};

/// Lines that contain the typed text, at most so many; those in headings first.
std::vector<HelpHit> searchHelp(const QString& typed, std::size_t most = 60);

}  // namespace keyblock
