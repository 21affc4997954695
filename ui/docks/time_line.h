// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The band across the window that tells which moment is shown: transport, readout,
// counts of events and the track below. Without a run it says how to get one.
#pragma once

#include "ui/docks/event_marks.h"

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
class TimeTrack;

class TimeLine : public QWidget {
    Q_OBJECT

public:
    /// \pre the commands of runs and of time are there.
    TimeLine(const Themes& themes, Commands& commands, TimeCursor& cursor, const BoltChoice& choice,
             QWidget* parent = nullptr);

private:
    QWidget* makeTransport();
    QWidget* makeCounts();
    QToolButton* buttonOf(const char* command);
    void showRun();
    void showMoment();
    void showCounts();
    void showIcons();
    void showBookmark();
    QString compareText() const;

    const Themes& themes_;
    Commands& commands_;
    TimeCursor& cursor_;
    const BoltChoice& choice_;
    QWidget *full_, *empty_;
    TimeTrack* track_;
    QToolButton *play_ = nullptr, *loop_ = nullptr, *bookmark_ = nullptr;
    QComboBox* speed_ = nullptr;
    QLabel *stage_ = nullptr, *time_ = nullptr, *frame_ = nullptr, *compare_ = nullptr;
    QToolButton* live_ = nullptr;
    std::array<QToolButton*, eventGroups> counts_{};
    std::size_t counted_ = 0;
    std::array<long, eventGroups> numbers_{};
};

}  // namespace keyblock
