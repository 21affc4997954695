// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All commands with their keyboard shortcuts, listed by menu. Shortcuts are changed
// here; if a new shortcut is taken already, the sheet names the command that will lose
// it.
#pragma once

#include <QKeySequence>
#include <QWidget>

class QAction;
class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace keyblock {

class Commands;
class Themes;

class KeySheet : public QWidget {
    Q_OBJECT

public:
    KeySheet(Commands& commands, const Themes& themes, QWidget* parent = nullptr);

private:
    QWidget* makeEditor();
    void list();
    QTreeWidgetItem* groupOf(const QString& menu) const;
    void filter();
    void showChosen();
    void showConflict();
    void change();
    void restore();
    void takeFromOthers(const QKeySequence& keys, const QAction* owner);
    QAction* chosen() const;

    Commands& commands_;
    const Themes& themes_;
    QLineEdit* filter_;
    QTreeWidget* sheet_;
    QKeySequenceEdit* keys_ = nullptr;
    QLabel *name_ = nullptr, *conflict_ = nullptr;
    QPushButton *set_ = nullptr, *original_ = nullptr;
};

/// The command with this shortcut, other than `but`; null if there is none.
QAction* commandWithKeys(const Commands& commands, const QKeySequence& keys, const QAction* but);

}  // namespace keyblock
