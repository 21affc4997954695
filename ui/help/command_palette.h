// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All commands by name: type a few letters, Enter runs one. It opens over the window
// and closes with Esc, with a click elsewhere, or when a command is chosen.
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
    QLabel* none_;  // message if nothing matches
    QStringList recent_;  // ids, newest first, saved in the settings
    QPoint mouse_;  // cursor position when an item was last chosen with the mouse [px of the screen]
};

/// Commands that match the typed text, best first; among equals, enabled ones first, then the most recently used.
QList<QAction*> commandsFor(const QString& typed, const Commands& commands, const QStringList& recent);

}  // namespace keyblock
