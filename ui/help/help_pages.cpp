// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_pages.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>

namespace keyblock {

namespace {

HelpPage read(const QFileInfo& info) {
    QFile file(info.filePath());
    HelpPage page{info.completeBaseName(), info.completeBaseName(), {}};
    if (file.open(QIODevice::ReadOnly)) page.text = QString::fromUtf8(file.readAll());
    page.text.remove(QRegularExpression("<!--.*?-->\\n?", QRegularExpression::DotMatchesEverythingOption));
    const auto heading = QRegularExpression("^# (.+)$", QRegularExpression::MultilineOption).match(page.text);
    if (heading.hasMatch()) page.title = heading.captured(1);
    return page;
}

QString plain(QString line) {
    line.remove(QRegularExpression("^[#>\\s|*-]+")).remove('`').remove("**").replace('|', ' ');
    return line.simplified();
}

void searchPage(const HelpPage& page, const QString& typed, std::vector<HelpHit>& hits) {
    QString heading;
    int occurrence = 0;
    for (const QString& line : page.text.split('\n')) {
        const QString words = plain(line);
        if (line.startsWith('#')) heading = words;
        const int here = words.count(typed, Qt::CaseInsensitive);
        if (here > 0) hits.push_back({&page, heading, words, occurrence});
        occurrence += here;
    }
}

}  // namespace

const std::vector<HelpPage>& helpPages() {
    static const std::vector<HelpPage> pages = [] {
        std::vector<HelpPage> read_;
        for (const QFileInfo& info : QDir(":/help").entryInfoList({"*.md"}, QDir::Files, QDir::Name))
            read_.push_back(read(info));
        std::ranges::stable_partition(read_, [](const HelpPage& page) { return page.name == "studio"; });
        return read_;
    }();
    return pages;
}

const HelpPage* findHelpPage(const QString& name) {
    const auto found = std::ranges::find(helpPages(), name, &HelpPage::name);
    return found == helpPages().end() ? nullptr : &*found;
}

std::vector<HelpHit> searchHelp(const QString& typed, std::size_t most) {
    std::vector<HelpHit> hits;
    const QString words = typed.simplified();
    if (words.isEmpty()) return hits;
    for (const HelpPage& page : helpPages()) searchPage(page, words, hits);
    std::ranges::stable_partition(hits, [&](const HelpHit& hit) { return hit.line == hit.heading; });
    if (hits.size() > most) hits.resize(most);
    return hits;
}

}  // namespace keyblock
