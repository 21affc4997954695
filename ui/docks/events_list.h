// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The events of the run, one per row: time, kind, location, force and causing event.
// Events after the time shown are dimmed. A click moves the time to the event and
// selects its bolt or block.
#pragma once

#include "solver/results/results.h"

#include <QAbstractTableModel>
#include <QWidget>

#include <vector>

class QLabel;
class QTreeView;

namespace keyblock {

class BoltChoice;
class Display;
class Themes;
class TimeCursor;

class EventsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Number, Time, What, Where, Force, Cause, columns };

    EventsModel(const Themes& themes, const Display& display, TimeCursor& cursor, QObject* parent = nullptr);

    /// The event shown in this row, as an index into the events of the run.
    std::size_t eventAt(int row) const { return rows_[row]; }

    /// Index of the last row that shows one of the first `events` events of the run; −1: no row shows any of them.
    int lastRowUntil(long events) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    void takeRun();
    void takeMore();

private:
    QVariant text(const Event& event, std::size_t number, int column) const;
    QString chainOf(std::size_t number) const;

    const Themes& themes_;
    const Display& display_;
    TimeCursor& cursor_;
    std::size_t seen_ = 0;  // number of events of the run that have been read
    std::vector<std::size_t> rows_;
};

class EventsList : public QWidget {
    Q_OBJECT

public:
    EventsList(const Themes& themes, const Display& display, TimeCursor& cursor, BoltChoice& choice,
               QWidget* parent = nullptr);

    std::size_t count() const;
    QSize sizeHint() const override { return {415, 214}; }

Q_SIGNALS:
    void blockAsked(int block, const QString& what);  // index among the solved blocks
    void countChanged();

private:
    void grow();
    void showMoment();
    void followMoment();
    void open(const QModelIndex& index);

    TimeCursor& cursor_;
    BoltChoice& choice_;
    EventsModel* model_;
    QTreeView* view_;
    QLabel* empty_;
    bool opening_ = false;  // true while an event that was clicked is being opened
};

}  // namespace keyblock
