// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run on its own thread, from start to end: its controls, progress and outcome.
// Exceptions in the thread become messages here. This is not a Background: the thread's
// lower priority and its processor clock belong to the run and end with it.
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

/// What to run, and the store to write.
struct RunOrder {
    std::shared_ptr<const Scene> scene;  // as written
    std::shared_ptr<const SceneCut> cut;  // its cut, if known
    std::filesystem::path store;
    bool resume = false;  // resume from the store
    int threads = 0;  // 0: as many as the machine has
};

class RunSession : public QObject {
    Q_OBJECT

public:
    enum class State { Preparing, Running, Paused, Stopping, Ended };

    explicit RunSession(RunOrder order, QObject* parent = nullptr);
    /// Stops the run if it is in progress; results so far are kept.
    ~RunSession() override;

    void start();
    void pause();
    void goOn();
    /// One step of a paused run; a running one is paused first.
    void step();
    void stop();

    /// How often states between stored frames are read; 0: never. Initially 30.
    void setLooksPerSecond(int looks);
    /// Processor time of the run's own thread so far [s]; 0 before it starts and once it is over.
    double threadSeconds() const;

    State state() const { return state_; }
    bool isOver() const { return state_ == State::Ended; }
    /// Null until the run has started.
    const std::shared_ptr<LiveRun>& run() const { return run_; }
    const RunOrder& order() const { return order_; }

    double fraction() const;  // of the whole run, 0 … 1
    std::optional<double> secondsLeft() const;  // none: too early to estimate
    QString stageText() const;  // "Stage 4 of 4 · Burst"
    QString searchText() const;  // during a long search for equilibrium, see `searchText`; else empty
    long steps() const;

    // Valid once the run is over.
    std::optional<Outcome> outcome() const { return outcome_; }  // of the last stage; none: an error occurred
    bool failed() const { return failed_; }  // it could not finish
    bool isUnstable() const;  // the rock is unstable in one of the stages
    QString message() const { return message_; }  // outcome, and what to do

Q_SIGNALS:
    void began();  // `run()` is available
    void advanced();  // events, frames or progress arrived, at most 30 times a second
    void stateChanged();
    void ended();

private:
    struct Ending {
        std::vector<StageResult> stages;
        QString problem;  // error message; empty: none
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
    Ending ending_;  // owned by the thread until it is joined
    mutable std::thread thread_;  // its handle is needed
    QTimer timer_;
    QElapsedTimer clock_, looked_;
    int looks_ = 30;  // per second
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
