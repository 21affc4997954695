// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run from start to end on a thread of its own: controls, progress and outcome.
// Exceptions in the thread are reported as messages. `Background` is not used, because
// the lower priority and the processor-time clock of the thread belong to the run and
// end with it.
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

/// The scene to run, and the store to which the run writes.
struct RunOrder {
    std::shared_ptr<const Scene> scene;  // the scene as in its file, not cut
    std::shared_ptr<const SceneCut> cut;  // the cut scene, if it is known already
    std::filesystem::path store;
    bool resume = false;  // resume the run in the store
    int threads = 0;  // 0: one per processor
};

class RunSession : public QObject {
    Q_OBJECT

public:
    enum class State { Preparing, Running, Paused, Stopping, Ended };

    explicit RunSession(RunOrder order, QObject* parent = nullptr);
    /// Stops the run if it is in progress, and waits for it to finish. Results so far are kept.
    ~RunSession() override;

    void start();
    void pause();
    void goOn();
    /// Computes one step of a paused run; pauses the run first if necessary.
    void step();
    void stop();

    /// Sets the rate at which states between stored frames are passed to the window [1/s]; 0: never. The default is 30.
    void setLooksPerSecond(int looks);
    /// Processor time used by the run's own thread [s]; 0 before the run starts and after it has ended.
    double threadSeconds() const;

    State state() const { return state_; }
    bool isOver() const { return state_ == State::Ended; }
    /// The run; null until it has started.
    const std::shared_ptr<LiveRun>& run() const { return run_; }
    const RunOrder& order() const { return order_; }

    double fraction() const;  // completed fraction of the whole run, 0 … 1
    std::optional<double> secondsLeft() const;  // none: too early to estimate
    QString stageText() const;  // "Stage 4 of 4 · Burst"
    QString searchText() const;  // text during a long search for equilibrium, from `searchText`; otherwise empty
    long steps() const;

    // Valid once the run is over.
    std::optional<Outcome> outcome() const { return outcome_; }  // of the last stage; none: an error occurred
    bool failed() const { return failed_; }  // the run could not be completed
    bool isUnstable() const;  // the section is unstable in at least one stage
    QString message() const { return message_; }  // the outcome, and what the user can do about it

Q_SIGNALS:
    void began();  // `run()` is available
    void advanced();  // new events, frames or progress; at most 30 times a second
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
    mutable std::thread thread_;  // mutable because `native_handle` is not const
    QTimer timer_;
    QElapsedTimer clock_, looked_;
    int looks_ = 30;  // states passed to the window per second
    qint64 paused_ = 0, pausedSince_ = -1;  // [ms]
    std::optional<double> startFraction_;
    State state_ = State::Preparing;
    std::shared_ptr<LiveRun> run_;
    std::optional<Outcome> outcome_;
    bool failed_ = false;
    QString message_;
};

/// Remaining time as text, e.g. "38 s left", "2 min left" or "1 h 20 min left".
QString leftText(double seconds);

}  // namespace keyblock
