// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_binding.h"

#include "ui/document/document.h"
#include "ui/look/notice_bar.h"
#include "ui/start/samples.h"
#include "ui/window/file_commands.h"

#include <QMainWindow>
#include <QStatusBar>

namespace keyblock {

namespace {

void openSample(const Sample& sample, Document& document, QMainWindow& window) {
    std::optional<Scene> scene = sampleScene(sample);
    if (!scene)
        window.statusBar()->showMessage(StartPage::tr("The sample %1 cannot be read.").arg(sample.title));
    else if (mayDiscard(document, window))
        document.startNew(std::move(*scene), sample.name);
}

}  // namespace

StartPage* addStartPage(QMainWindow& window, const StartPage::Rooms& rooms) {
    auto* page = new StartPage(rooms, &window);
    Document& document = rooms.document;
    Journal& journal = rooms.journal;
    QObject::connect(page, &StartPage::openWanted, &window,
                     [&](const QString& path) { openDocument(document, path, window); });
    QObject::connect(page, &StartPage::sampleWanted, &window,
                     [&](const Sample& sample) { openSample(sample, document, window); });
    QObject::connect(page, &StartPage::recoverWanted, &window, [&, page](const Abandoned& abandoned, Recover what) {
        if (!mayDiscard(document, window)) return;
        const QString why = recover(abandoned, what, document, journal);
        if (why.isEmpty()) return;
        window.statusBar()->showMessage(why);
        page->open();
    });
    QObject::connect(page, &StartPage::reported, &window,
                     [&](const QString& text) { window.statusBar()->showMessage(text); });
    addStartCommands(rooms.commands, *page);
    return page;
}

void beginWithStartPage(StartPage& page) {
    if (StartPage::isWantedAtStart() || !page.lookForAbandoned().empty()) page.open();
}

void tellAbandoned(StartPage& page, const Themes& themes, QWidget* canvas) {
    const std::vector<Abandoned> found = page.lookForAbandoned();
    if (found.empty()) return;
    const QString text = found.size() == 1
                             ? StartPage::tr("%1 was not closed properly. Its edits can be recovered.").arg(found[0].title)
                             : StartPage::tr("%1 scenes were not closed properly. Their edits can be recovered.").arg(found.size());
    auto* bar = new NoticeBar(themes, canvas);
    bar->say(text, {{StartPage::tr("Recover…"), [&page] { page.open(); }}});
}

}  // namespace keyblock
