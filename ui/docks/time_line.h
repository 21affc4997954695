// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The timeline across the window: playback controls, the time shown, event counts, and
// the track below. If there is no run, it explains how to start one.
#pragma once

#include "solver/results/event_groups.h"

#include <QWidget>

#include <array>

class QComboBox;
class QLabel;
class QToolButton;

namespace keyblock {

class BoltChoice;
class Commands;
class Themes;
class TimeCursor;
class Display;
class TimeTrack;

class TimeLine : public QWidget {
    Q_OBJECT

public:
    /// \pre the commands for runs and for the time shown have been added to `commands`.
    TimeLine(const Themes& themes, const Display& display, Commands& commands, TimeCursor& cursor,
             const BoltChoice& choice, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeTransport();
    QWidget* makeCounts();
    QToolButton* iconButton(const char* command);
    void showRun();
    void showMoment();
    void showCounts();
    void showIcons();
    void showBookmark();
    void fit();
    void showAsShort(int level);
    void nameCounts();
    QString compareText() const;

    const Themes& themes_;
    const Display& display_;
    Commands& commands_;
    TimeCursor& cursor_;
    const BoltChoice& choice_;
    QWidget *full_, *empty_;
    QWidget *transport_ = nullptr, *countsBar_ = nullptr;
    TimeTrack* track_;
    QToolButton *play_ = nullptr, *loop_ = nullptr, *bookmark_ = nullptr;
    QComboBox* speed_ = nullptr;
    QLabel *stage_ = nullptr, *time_ = nullptr, *frame_ = nullptr, *compare_ = nullptr;
    QToolButton *live_ = nullptr, *next_ = nullptr;
    QLabel* events_ = nullptr;
    std::array<QToolButton*, eventGroups.size()> counts_{};
    int short_ = 0;  // level of abbreviation; 0: everything is shown in full
    std::size_t counted_ = 0;
    EventCounts numbers_;
};

}  // namespace keyblock
