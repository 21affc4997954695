// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The registry of all named commands: menus, shortcuts, tooltips, the palette and
// the key sheet are made from it. Each part of the window adds its own commands.
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

/// The first shortcut of a command as text; empty: none.
QString keysOf(const QAction& action);

struct CommandText {
    QString id;  // part.verb, as kept in settings: run.start
    QString text;  // Run
    QString menu;  // File, Edit, View, Insert, Run, Results, Tools, Help; empty: only in the palette
    QString icon;  // name of the icon; empty: none
    QString help;  // one sentence, for the tooltip and the palette
    QList<QKeySequence> keys{};
    bool checkable = false;
    QString group{};  // groups of a menu are separated by lines
};

/// Commits text being typed in a field, as leaving the field would; the focus stays. Every command starts with this,
/// so that it uses the text typed last.
void finishTyping();

class Commands : public QObject {
    Q_OBJECT

public:
    explicit Commands(const Themes& themes, QObject* parent = nullptr);

    /// Adds a command; keys chosen by the user override the given ones. The state of a checkable command is its
    /// action's `isChecked()`. \pre the id is unique.
    QAction* add(const CommandText& text, std::function<void()> run);

    /// \pre there is one of that id.
    QAction* action(const QString& id) const;
    bool has(const QString& id) const;

    /// In the order in which they were added.
    const std::vector<QAction*>& all() const { return actions_; }
    QString menuOf(const QAction* action) const;
    QString groupOf(const QAction* action) const;

    /// Disables a command and shows the reason in its tooltip and in the palette; empty: enables it.
    void setWhyNot(const QString& id, const QString& why);
    QString whyNot(const QAction* action) const;

    /// The command in texts: its keys, else its name: `F5`, `“Run”`.
    QString callOf(const QString& id) const;

    /// Sets other keys for the command, kept in the settings; empty: the default ones.
    void setKeys(const QString& id, const QList<QKeySequence>& keys);

Q_SIGNALS:
    void keysChanged();

private:
    void describe(QAction* action) const;

    const Themes& themes_;
    std::vector<QAction*> actions_;
};

}  // namespace keyblock
