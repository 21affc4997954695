// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One registry of everything a person can do by name: menus, keys, tooltips, the
// palette and the key sheet are made from it. Each room adds its own.
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

/// The first keys of a command as they are written; empty: none.
QString keysOf(const QAction& action);

struct CommandText {
    QString id;  // room.verb, as kept in settings: run.start
    QString text;  // Run
    QString menu;  // File, Edit, View, Insert, Run, Results, Tools, Help; empty: only in the palette
    QString icon;  // name; empty: none
    QString help;  // one sentence, for the tooltip and the palette
    QList<QKeySequence> keys{};
    bool checkable = false;
    QString group{};  // commands of one group of a menu stand together, a line between groups
};

/// Enters what a person is typing in a field, as leaving the field would; the cursor stays there. Every command begins
/// so: what is run, saved or asked about holds what was typed last.
void finishTyping();

class Commands : public QObject {
    Q_OBJECT

public:
    explicit Commands(const Themes& themes, QObject* parent = nullptr);

    /// Adds a command; keys that a person has chosen for it win over the given ones. A checkable one is told by its
    /// action's `isChecked()`. \pre no other has its id.
    QAction* add(const CommandText& text, std::function<void()> run);

    /// \pre there is one of that id.
    QAction* action(const QString& id) const;
    bool has(const QString& id) const;

    /// In the order in which they were added.
    const std::vector<QAction*>& all() const { return actions_; }
    QString menuOf(const QAction* action) const;
    QString groupOf(const QAction* action) const;

    /// Switches a command off and tells why it would do nothing, in its tooltip and in the palette; empty: it is on.
    void setWhyNot(const QString& id, const QString& why);
    QString whyNot(const QAction* action) const;

    /// How texts call the command: its keys, else its name: `F5`, `“Run”`.
    QString callOf(const QString& id) const;

    /// Gives the command other keys, kept for the next start; empty: the original ones.
    void setKeys(const QString& id, const QList<QKeySequence>& keys);

Q_SIGNALS:
    void keysChanged();

private:
    void describe(QAction* action) const;

    const Themes& themes_;
    std::vector<QAction*> actions_;
};

}  // namespace keyblock
