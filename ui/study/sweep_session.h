// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A sweep in its folder: runs the cases that are not finished by `keyblock sweep run`, as
// a scheduler would, and reads their results as they finish. A case that ends its
// process does not end the window.
#pragma once

#include "solver/study/study_file.h"
#include "solver/study/sweep_folder.h"
#include "solver/study/sweep_results.h"
#include "ui/document/background.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include <deque>
#include <memory>
#include <optional>
#include <vector>

class QProcess;

namespace keyblock {

/// A sweep that was opened, with what has been read of it.
struct OpenedSweep {
    Sweep sweep;
    std::vector<std::string> quantities;
    SweepResults results;
    std::vector<std::string> damaged;  // summaries that cannot be read, with the reason
};

class SweepSession : public QObject {
    Q_OBJECT

public:
    explicit SweepSession(QObject* parent = nullptr);
    /// Stops the cases in progress and waits for their processes.
    ~SweepSession() override;

    /// The program `keyblock`: next to this one, or where the system finds it; empty if there is none.
    static QString programPath();
    /// Uses another program, for tests.
    void setProgram(const QString& path) { program_ = path; }

    /// Plans a sweep in a new folder, and runs it. \pre `reading` has no errors, and nothing is running
    void plan(std::shared_ptr<const StudyReading> reading, const QString& folder);
    /// Reads the sweep in a folder. \param runs also runs its unfinished cases
    void open(const QString& folder, bool runs = false);
    /// Runs the cases of the sweep that are not finished.
    void run();
    /// Stops within one step; finished cases stay, and those in progress can be resumed.
    void stop();
    /// Shows no sweep.
    void close();

    bool isReading() const { return isReading_; }
    bool isRunning() const { return !processes_.empty(); }
    bool isStopping() const { return isStopping_ && isRunning(); }

    const std::shared_ptr<const OpenedSweep>& opened() const { return opened_; }  // null: no sweep
    long cases() const { return opened_ ? opened_->sweep.plan.cases : 0; }
    long finished() const { return finished_; }
    /// Time until all cases are finished [s]; none while it is not known.
    std::optional<double> secondsLeft() const;
    const QString& problem() const { return problem_; }  // why it did not run to its end; empty: none

Q_SIGNALS:
    void changed();  // results, progress or state
    void replaced();  // another sweep, or none, is shown
    void ended();  // all cases are finished, or it was stopped

private:
    struct Task {
        long first, last;
    };
    Background::Result readFolder(const std::string& folder, bool runs);
    void take(std::shared_ptr<OpenedSweep> sweep, const QString& problem, bool runs);
    void fillQueue();
    void startNext();
    void readOutput(QProcess& process);
    void processEnded(QProcess* process, int code, bool crashed);
    void readFinished();
    void fail(const QString& why);

    QString program_ = programPath();
    std::shared_ptr<const OpenedSweep> opened_;
    bool isReading_ = false, isStopping_ = false;
    QString problem_;
    long finished_ = 0, finishedBefore_ = 0;
    std::deque<Task> queue_;
    std::vector<QProcess*> processes_;
    std::vector<long> reported_;  // cases that have finished but are not read yet
    QElapsedTimer since_;
    QTimer poll_;
    Background reading_;  // last member: its destructor waits for the thread
};

}  // namespace keyblock
