// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run on a thread of its own, from its start until it ended: what a person can
// do with it while it goes, how far it is, and what became of it. Whatever goes
// wrong in the thread ends as words here.
#pragma once

#include "solver/run/run.h"
#include "ui/runs/live_feed.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace keyblock {

class LiveRun;

/// What to run, and into which store.
struct RunOrder {
    std::shared_ptr<const Scene> scene;  // as it is written
    std::shared_ptr<const SceneCut> cut;  // what it was cut to, where that is known
    std::filesystem::path store;
    bool resume = false;  // go on with what the store holds
    int threads = 0;  // 0: as many as the machine has
};

class RunSession : public QObject {
    Q_OBJECT

public:
    enum class State { Preparing, Running, Paused, Stopping, Ended };

    explicit RunSession(RunOrder order, QObject* parent = nullptr);
    /// Stops the run where it still goes; what is done is kept.
    ~RunSession() override;

    void start();
    void pause();
    void goOn();
    /// One step of a run that is paused; one that runs is paused first.
    void step();
    void stop();

    /// How often states between stored frames are looked at; 0: never. At the start 30.
    void setLooksPerSecond(int looks);
    /// Processor time that the run's own thread took so far [s]; 0 before it starts and once it is over.
    double threadSeconds() const;

    State state() const { return state_; }
    bool isOver() const { return state_ == State::Ended; }
    /// Null until the run has begun.
    const std::shared_ptr<LiveRun>& run() const { return run_; }
    const RunOrder& order() const { return order_; }

    double fraction() const;  // of the whole run, 0 … 1
    std::optional<double> secondsLeft() const;  // none: too early to tell
    QString stageText() const;  // "Stage 4 of 4 · Burst"
    QString searchText() const;  // of a long search for equilibrium, as of `searchText`; else empty
    long steps() const;

    // Once it is over.
    std::optional<Outcome> outcome() const { return outcome_; }  // of the last stage; none: something went wrong
    bool failed() const { return failed_; }  // it could not go to its end
    bool isUnstable() const;  // rock does not stand in one of the stages
    QString message() const { return message_; }  // what became of it, and what to do

Q_SIGNALS:
    void began();  // `run()` is there
    void advanced();  // events, frames or progress came, at most 30 times a second
    void stateChanged();
    void ended();

private:
    struct Ending {
        std::vector<StageResult> stages;
        QString problem;  // what went wrong; empty: nothing
        bool nothingToDo = false;
    };

    void work(Ending& ending);
    void runIt(Ending& ending);
    void takeFeed();
    void finish();
    void tellEnding();
    QString finishedMessage() const;
    void setState(State state);

    RunOrder order_;
    Control control_;
    LiveFeed feed_;
    Ending ending_;  // the thread's until it is joined
    mutable std::thread thread_;  // its handle is asked for
    QTimer timer_;
    QElapsedTimer clock_, looked_;
    int looks_ = 30;  // a second
    qint64 paused_ = 0, pausedSince_ = -1;  // [ms]
    std::optional<double> startFraction_;
    State state_ = State::Preparing;
    std::shared_ptr<LiveRun> run_;
    std::optional<Outcome> outcome_;
    bool failed_ = false;
    QString message_;
};

/// "38 s left", "2 min left", "1 h 20 min left".
QString leftText(double seconds);

}  // namespace keyblock
