// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/action_button.h"

#include <QAction>
#include <QToolButton>

namespace keyblock {

void follow(QAbstractButton& button, QAction& action, std::function<QString()> text) {
    const auto show = [&button, &action, text = std::move(text)] {
        button.setEnabled(action.isEnabled());
        button.setAccessibleName(action.text());
        button.setToolTip(action.toolTip());
        if (text) button.setText(text());
    };
    show();
    QObject::connect(&action, &QAction::changed, &button, show);
    QObject::connect(&button, &QAbstractButton::clicked, &action, &QAction::trigger);
}

QToolButton* buttonOf(QAction& action, QWidget* parent, std::function<QString()> text) {
    auto* button = new QToolButton(parent);
    button->setObjectName(action.objectName());
    button->setIconSize({16, 16});
    follow(*button, action, std::move(text));
    return button;
}

}  // namespace keyblock
