// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every command by its name: type a few letters, Enter runs it. It lies over the
// window and goes with Esc, with a click elsewhere, or once a command is chosen.
#pragma once

#include <QFrame>
#include <QPoint>
#include <QStringList>

class QAction;
class QLineEdit;
class QLabel;
class QListWidget;

namespace keyblock {

class Commands;
class Themes;

class CommandPalette : public QFrame {
    Q_OBJECT

public:
    CommandPalette(const Commands& commands, const Themes& themes, QWidget* window);

    void open();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void list();
    void chooseUnderMouse();
    void run();
    void place();

    const Commands& commands_;
    const Themes& themes_;
    QLineEdit* typed_;
    QListWidget* found_;
    QLabel* none_;  // what is said where nothing fits
    QStringList recent_;  // ids, newest first, kept in the settings
    QPoint mouse_;  // where it was when something was last chosen by it [px of the screen]
};

/// Commands that fit what is typed, best first; of equals those that can be used, and of those the last used.
QList<QAction*> commandsFor(const QString& typed, const Commands& commands, const QStringList& recent);

}  // namespace keyblock
