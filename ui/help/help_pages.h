// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The help pages that come within the program, and where a word stands in them.
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

/// The page of that name; null when there is none.
const HelpPage* findHelpPage(const QString& name);

struct HelpHit {
    const HelpPage* page = nullptr;
    QString heading;  // that it stands below
    QString line;  // without marks of Markdown
    int occurrence = 0;  // of the words typed in the page, from 0
};

/// Lines that hold what is typed, at most so many; those in headings first.
std::vector<HelpHit> searchHelp(const QString& typed, std::size_t most = 60);

}  // namespace keyblock
