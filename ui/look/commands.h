// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Registry of all commands by name. Menus, shortcuts, tooltips, the command palette and
// the key sheet are created from it. Each part of the window adds its own commands.
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

namespace keyblock {

class Themes;

/// The first shortcut of a command as text; empty if it has none.
QString keysOf(const QAction& action);

struct CommandText {
    QString id;  // part.verb, such as run.start; also used in the settings
    QString text;  // name in the menu, such as Run
    QString menu;  // File, Edit, View, Insert, Run, Results, Tools, Help; empty: only in the palette
    QString icon;  // name of the icon; empty: no icon
    QString help;  // one sentence, for the tooltip and the palette
    QList<QKeySequence> keys{};
    bool checkable = false;
    QString group{};  // separator lines divide the groups of a menu
};

/// Commits the text that is being typed in a field, as if the user had left the field. The focus does not change. Every
/// command calls this first, so that it uses the latest input.
void finishTyping();

class Commands : public QObject {
    Q_OBJECT

public:
    explicit Commands(const Themes& themes, QObject* parent = nullptr);

    /// Adds a command. Keys chosen by the user override the keys in `text`. The state of a checkable command is
    /// `isChecked()` of its action.
    /// \pre the id is unique.
    QAction* add(const CommandText& text, std::function<void()> run);

    /// The action of a command. \pre the command exists.
    QAction* action(const QString& id) const;
    bool has(const QString& id) const;

    /// All commands, in the order in which they were added.
    const std::vector<QAction*>& all() const { return actions_; }
    QString menuOf(const QAction* action) const;
    QString groupOf(const QAction* action) const;

    /// Disables a command and shows the reason `why` in its tooltip and in the palette; an empty reason enables it.
    void setWhyNot(const QString& id, const QString& why);
    QString whyNot(const QAction* action) const;

    /// Text that refers to the command in messages: its keys, e.g. `F5`. If it has no keys, its name is used, e.g.
    /// `“Run”`.
    QString callOf(const QString& id) const;

    /// Sets the keys of a command and saves them in the settings; an empty list restores the default keys.
    void setKeys(const QString& id, const QList<QKeySequence>& keys);

Q_SIGNALS:
    void keysChanged();

private:
    void describe(QAction* action) const;

    const Themes& themes_;
    std::vector<QAction*> actions_;
};

}  // namespace keyblock
