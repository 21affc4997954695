// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_menu.h"

#include "ui/document/recent_files.h"
#include "ui/look/plain_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include <algorithm>

namespace keyblock {

namespace {

constexpr std::size_t mostRecent = 10;

void fillRecent(QMenu& menu, const RecentFiles& recent, const std::function<void(const QString&)>& open) {
    menu.clear();
    const auto& files = recent.files();
    for (std::size_t i = 0; i < std::min(files.size(), mostRecent); ++i) {
        const QFileInfo file(files[i].path);
        QAction* entry = menu.addAction(asMenuText(file.fileName()), &menu, [open, path = files[i].path] { open(path); });
        entry->setToolTip(asTip(file.filePath()));
        entry->setEnabled(file.exists());
    }
    if (menu.isEmpty()) menu.addAction(QMainWindow::tr("No recent scenes"))->setEnabled(false);
}

void addRecent(QMenu& file, const RecentFiles& recent, const std::function<void(const QString&)>& open) {
    auto* menu = new QMenu(QMainWindow::tr("Open recent"), &file);
    menu->setObjectName("menu.recent");
    menu->setToolTipsVisible(true);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, &recent, open] { fillRecent(*menu, recent, open); });
    const QList<QAction*> actions = file.actions();
    const auto at = std::find_if(actions.begin(), actions.end(),
                                 [](const QAction* action) { return action->objectName() == "file.open"; });
    file.insertMenu(at == actions.end() || at + 1 == actions.end() ? nullptr : *(at + 1), menu);
}

/// The box is not modal, so work can continue.
void showAbout(QMainWindow& window) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, QMainWindow::tr("About Keyblock"),
                                QMainWindow::tr("Keyblock %1").arg(QCoreApplication::applicationVersion()),
                                QMessageBox::Close, &window);
    box->setInformativeText(QMainWindow::tr("Two-dimensional discontinuous deformation analysis of blocky rock with rock "
                                            "bolts.\n\nFree software under the GNU General Public License, version 3 or "
                                            "later."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}  // namespace

void addToMenus(QMainWindow& window, const RecentFiles& recent, std::function<void(const QString&)> open) {
    if (auto* file = window.menuBar()->findChild<QMenu*>("menu.File")) addRecent(*file, recent, open);
    auto* help = window.menuBar()->findChild<QMenu*>("menu.Help");
    if (!help) return;
    help->addSeparator();
    help->addAction(QMainWindow::tr("About Keyblock"), &window, [&window] { showAbout(window); })->setObjectName("help.about");
}

}  // namespace keyblock
