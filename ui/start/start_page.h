// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The start page, from which the user creates, recovers or reopens a scene, or opens a
// sample. It covers the window between the menu bar and the status bar until a document
// is open. The command view.start shows it again.
#pragma once

#include "ui/document/recovery.h"

#include <QWidget>

class QVBoxLayout;

namespace keyblock {

class Commands;
class Document;
class Gallery;
class Journal;
class RecentFiles;
class Themes;
class Thumbnails;
struct Sample;

class StartPage : public QWidget {
    Q_OBJECT

public:
    /// Objects that the start page uses; all must outlive it.
    struct Rooms {
        Themes& themes;
        Commands& commands;
        Document& document;
        Journal& journal;
        RecentFiles& recent;
    };

    /// \param covered widget that the page covers; the page is resized with it
    StartPage(const Rooms& rooms, QWidget* covered);

    static bool isWantedAtStart();

    /// Searches for scenes that can be recovered, and shows the page.
    void open();

    /// Searches for scenes that can be recovered, and returns them. Reports journals that cannot be read.
    std::vector<Abandoned> lookForAbandoned();

Q_SIGNALS:
    void openWanted(const QString& path);
    void sampleWanted(const keyblock::Sample& sample);
    void recoverWanted(const keyblock::Abandoned& abandoned, keyblock::Recover what);
    void reported(const QString& message);  // shown in the status bar

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeSide();
    QWidget* makeTitle();
    QWidget* makeButtons();
    QWidget* makeFoot();
    QWidget* makeCommandButton(const QString& id, bool primary);
    void showRecovery();
    void showIcons();
    void showRecent();
    void follow();
    void fitSide(bool narrow);
    void stackAboveDocks();

    Rooms rooms_;
    Thumbnails* thumbnails_;
    QVBoxLayout* recovery_ = nullptr;  // created together with the side column
    QVBoxLayout* recent_ = nullptr;
    QWidget* side_;
};

/// Adds the command view.start, which shows the page again.
void addStartCommands(Commands& commands, StartPage& page);

}  // namespace keyblock
