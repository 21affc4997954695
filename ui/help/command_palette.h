// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A list of all commands that the user searches by typing a few letters; Enter runs the
// selected command. The palette opens over the window and closes with Esc, with a click
// elsewhere, or when a command is chosen.
#pragma once

#include <QFrame>
#include <QPoint>
#include <QPointer>
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
    void leave();
    void list();
    void chooseUnderMouse();
    void run();
    void place();

    const Commands& commands_;
    const Themes& themes_;
    QLineEdit* typed_;
    QListWidget* found_;
    QLabel* none_;  // message if no command matches
    QStringList recent_;  // ids of recently used commands, latest first, saved in the settings
    QPointer<QWidget> before_;  // had the focus when the palette was opened
    QPoint mouse_;  // cursor position on the screen when the mouse last selected an item [px]
};

/// Commands that match the typed text, best match first. Among equally good matches, enabled commands come first, then
/// the most recently used ones.
/// \param recent ids of recently used commands, latest first.
QList<QAction*> commandsFor(const QString& typed, const Commands& commands, const QStringList& recent);

}  // namespace keyblock
