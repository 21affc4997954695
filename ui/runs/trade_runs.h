// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures what the numerical settings of the document's scene cost and what they
// change, in the background, so that the window stays usable.
#pragma once

#include "solver/run/run.h"
#include "solver/trade/trade.h"
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

class TradeRuns : public QObject {
    Q_OBJECT

public:
    explicit TradeRuns(const Document& document, QObject* parent = nullptr);
    /// Stops the runs and waits for their thread.
    ~TradeRuns() override;

    /// Starts the runs for the current document, unless some are in progress.
    void start();
    /// Stops them; the points measured so far stay.
    void stop();
    bool isBusy() const { return busy_; }

    const Trade& trade() const { return trade_; }  // as measured so far
    const std::shared_ptr<const Scene>& scene() const { return scene_; }  // that is measured
    const QString& problem() const { return problem_; }  // why there is no trade; empty: no error
    const QString& label() const { return label_; }  // what is being run, with the time left
    /// Completed fraction of all runs, 0 … 1.
    double fraction() const;
    /// Whether the document's scene is still the one that was measured.
    bool isCurrent() const;

Q_SIGNALS:
    void changed();
    void ended();  // all runs have been made, or they were stopped

private:
    Background::Result measureAll();
    void take();
    void finish(const std::string& problem);

    const Document& document_;
    std::shared_ptr<const Scene> scene_;
    bool busy_ = false;
    Trade trade_;
    QString problem_, label_;
    std::atomic<double> fraction_{0.0};  // of the run in progress
    Control control_;
    std::mutex mutex_;  // protects the next two, which the thread fills
    Trade newTrade_;
    std::string newLabel_;
    QTimer poll_;
    Background measuring_;  // last member: its destructor waits for the thread, which uses the other members
};

}  // namespace keyblock
