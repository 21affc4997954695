// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pushes the document's scene along its settings until something breaks, in the
// background, so that the window stays usable.
#pragma once

#include "solver/run/run.h"
#include "solver/trade/stress.h"
#include "ui/document/background.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace keyblock {

class Document;

class StressRuns : public QObject {
    Q_OBJECT

public:
    explicit StressRuns(const Document& document, QObject* parent = nullptr);
    /// Stops the runs and waits for their thread.
    ~StressRuns() override;

    /// Starts the test of the current document, unless one is in progress.
    void start();
    /// Stops it; the pushes made so far stay.
    void stop();
    bool isBusy() const { return busy_; }

    const StressTest& test() const { return test_; }  // as made so far
    bool hasEnded() const { return ended_; }  // a test was made, in whole or in part
    const QString& problem() const { return problem_; }  // why there is no test; empty: no error
    const QString& label() const { return label_; }  // what is being run
    /// Completed fraction of all runs, 0 … 1.
    double fraction() const;
    /// Whether the document's scene is still the one that was tested.
    bool isCurrent() const;

Q_SIGNALS:
    void changed();

private:
    Background::Result pushAll();
    void take();
    void finish(const std::string& problem);

    const Document& document_;
    std::shared_ptr<const Scene> scene_;
    bool busy_ = false, ended_ = false;
    std::size_t planned_ = 1;  // runs
    StressTest test_;
    QString problem_, label_;
    std::atomic<double> fraction_{0.0};  // of the run in progress
    Control control_;
    std::mutex mutex_;  // protects the next two, which the thread fills
    StressTest newTest_;
    std::string newLabel_;
    QTimer poll_;
    Background pushing_;  // last member: its destructor waits for the thread, which uses the other members
};

}  // namespace keyblock
