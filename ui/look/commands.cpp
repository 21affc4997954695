// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/commands.h"

#include "ui/look/theme.h"

#include <QApplication>
#include <QLineEdit>
#include <QPointer>
#include <QSettings>

#include <algorithm>
#include <cassert>

namespace keyblock {

namespace {

// `icon` is already a property of QAction.
constexpr char menuKey[] = "menu", groupKey[] = "group", iconKey[] = "iconName", helpKey[] = "help", keysKey[] = "keys",
               whyNotKey[] = "whyNot";

QString settingOf(const QString& id) { return "keys/" + id; }

QList<QKeySequence> chosenKeys(const QString& id, const QList<QKeySequence>& original) {
    const QSettings settings;
    if (!settings.contains(settingOf(id))) return original;
    return QKeySequence::listFromString(settings.value(settingOf(id)).toString());
}

}  // namespace

QString keysOf(const QAction& action) { return action.shortcut().toString(QKeySequence::NativeText); }

void finishTyping() {
    const QPointer<QLineEdit> line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    if (!line) return;
    line->clearFocus();
    if (line && line->isVisible()) line->setFocus();  // a line edit in a table cell closes when its text is entered
}

Commands::Commands(const Themes& themes, QObject* parent) : QObject(parent), themes_(themes) {
    connect(&themes, &Themes::changed, this, [this] {
        for (QAction* action : actions_) describe(action);
    });
}

QAction* Commands::add(const CommandText& text, std::function<void()> run) {
    assert(!has(text.id));
    auto* action = new QAction(text.text, this);
    action->setObjectName(text.id);
    action->setCheckable(text.checkable);
    action->setProperty(menuKey, text.menu);
    action->setProperty(groupKey, text.group);
    action->setProperty(iconKey, text.icon);
    action->setProperty(helpKey, text.help);
    action->setProperty(keysKey, QKeySequence::listToString(text.keys));
    action->setShortcuts(chosenKeys(text.id, text.keys));
    action->setShortcutContext(Qt::WindowShortcut);
    describe(action);
    connect(action, &QAction::triggered, this, [run = std::move(run)] {
        finishTyping();
        run();
    });
    actions_.push_back(action);
    return action;
}

QAction* Commands::action(const QString& id) const {
    const auto found = std::ranges::find_if(actions_, [&](QAction* a) { return a->objectName() == id; });
    assert(found != actions_.end());
    return *found;
}

bool Commands::has(const QString& id) const {
    return std::ranges::any_of(actions_, [&](QAction* a) { return a->objectName() == id; });
}

QString Commands::menuOf(const QAction* action) const { return action->property(menuKey).toString(); }
QString Commands::groupOf(const QAction* action) const { return action->property(groupKey).toString(); }

void Commands::setWhyNot(const QString& id, const QString& why) {
    QAction* changed = action(id);
    changed->setEnabled(why.isEmpty());
    if (why == whyNot(changed)) return;
    changed->setProperty(whyNotKey, why);
    describe(changed);
}

QString Commands::whyNot(const QAction* action) const { return action->property(whyNotKey).toString(); }

QString Commands::callOf(const QString& id) const {
    const QString keys = keysOf(*action(id));
    return keys.isEmpty() ? tr("“%1”").arg(action(id)->text().remove(QStringLiteral("…"))) : keys;
}

void Commands::setKeys(const QString& id, const QList<QKeySequence>& keys) {
    QAction* changed = action(id);
    if (keys.isEmpty()) {
        QSettings().remove(settingOf(id));
        changed->setShortcuts(QKeySequence::listFromString(changed->property(keysKey).toString()));
    } else {
        QSettings().setValue(settingOf(id), QKeySequence::listToString(keys));
        changed->setShortcuts(keys);
    }
    describe(changed);
    Q_EMIT keysChanged();
}

void Commands::describe(QAction* action) const {
    const QString icon = action->property(iconKey).toString();
    if (!icon.isEmpty()) action->setIcon(themes_.icon(icon));
    const QString keys = QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText);
    const QString help = action->property(helpKey).toString(), why = whyNot(action);
    QString tip = action->text().remove(QStringLiteral("…"));
    if (!keys.isEmpty()) tip += " (" + keys + ")";
    for (const QString& line : {help, why})
        if (!line.isEmpty()) tip += '\n' + line;
    action->setToolTip(tip);
    action->setStatusTip(help);
}

}  // namespace keyblock
