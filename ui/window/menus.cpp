// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/menus.h"

#include "ui/look/commands.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>

#include <array>

namespace keyblock {

namespace {

constexpr std::array menuNames{
    QT_TRANSLATE_NOOP("Menus", "File"),    QT_TRANSLATE_NOOP("Menus", "Edit"),  QT_TRANSLATE_NOOP("Menus", "View"),
    QT_TRANSLATE_NOOP("Menus", "Insert"),  QT_TRANSLATE_NOOP("Menus", "Run"),
    QT_TRANSLATE_NOOP("Menus", "Results"), QT_TRANSLATE_NOOP("Menus", "Tools"), QT_TRANSLATE_NOOP("Menus", "Help")};

/// Groups of a menu, in the order in which their first commands were added.
QStringList groupsOfMenu(const Commands& commands, const QString& menu) {
    QStringList groups;
    for (const QAction* action : commands.all())
        if (commands.menuOf(action) == menu) groups << commands.groupOf(action);
    groups.removeDuplicates();
    return groups;
}

void fillMenu(QMenu& menu, const Commands& commands, const QString& name) {
    for (const QString& group : groupsOfMenu(commands, name)) {
        if (!menu.isEmpty()) menu.addSeparator();
        for (QAction* action : commands.all())
            if (commands.menuOf(action) == name && commands.groupOf(action) == group) menu.addAction(action);
    }
}

}  // namespace

void fillMenus(QMenuBar& bar, const Commands& commands) {
    for (const char* name : menuNames) {
        if (groupsOfMenu(commands, name).isEmpty()) continue;
        QMenu* menu = bar.addMenu("&" + QCoreApplication::translate("Menus", name));
        menu->setObjectName(QString("menu.%1").arg(name));
        fillMenu(*menu, commands, name);
    }
}

void placeAtRight(QMenuBar& bar, const std::vector<QWidget*>& widgets) {
    auto* corner = new QWidget(&bar);
    auto* row = new QHBoxLayout(corner);
    row->setContentsMargins(0, 2, 8, 2);
    row->setSpacing(8);
    for (QWidget* widget : widgets) row->addWidget(widget);
    bar.setCornerWidget(corner, Qt::TopRightCorner);
}

}  // namespace keyblock
