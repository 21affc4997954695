// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/overflow_menu.h"

#include "ui/look/plain_text.h"

#include <QComboBox>
#include <QMenu>
#include <QToolButton>

namespace keyblock {

namespace {

void addChoices(QMenu& menu, QComboBox& box) {
    QMenu* choices = menu.addMenu(asMenuText(box.accessibleName()));
    choices->setEnabled(box.isEnabled());
    for (int i = 0; i < box.count(); ++i) {
        QAction* choice = choices->addAction(asMenuText(box.itemText(i)), &box, [&box, i] {
            box.setCurrentIndex(i);
            Q_EMIT box.activated(i);
        });
        choice->setCheckable(true);
        choice->setChecked(i == box.currentIndex());
    }
}

void addButton(QMenu& menu, QToolButton& button) {
    if (button.defaultAction()) return menu.addAction(button.defaultAction());
    QAction* entry = menu.addAction(button.icon(), asMenuText(button.accessibleName()), &button, &QToolButton::click);
    entry->setCheckable(button.isCheckable());
    entry->setChecked(button.isChecked());
    entry->setEnabled(button.isEnabled());
}

}  // namespace

void addToMenu(QMenu& menu, QWidget& control) {
    if (auto* box = qobject_cast<QComboBox*>(&control)) addChoices(menu, *box);
    else if (auto* button = qobject_cast<QToolButton*>(&control)) addButton(menu, *button);
}

}  // namespace keyblock
