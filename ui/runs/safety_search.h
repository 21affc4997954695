// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Searches for the factor of safety of the document on its own thread while the window
// stays usable.
#pragma once

#include "solver/run/safety.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace keyblock {

class Document;

class SafetySearch : public QObject {
    Q_OBJECT

public:
    explicit SafetySearch(const Document& document, QObject* parent = nullptr);
    /// Stops and waits.
    ~SafetySearch() override;

    /// Searches for the factor of the current document, unless a search is in progress.
    void start();
    void stop();
    bool isBusy() const { return busy_; }

    // Of the latest search.
    const std::vector<SafetyRun>& runs() const { return runs_; }
    const std::optional<SafetyFactor>& found() const { return found_; }  // none: it is not finished
    const QString& problem() const { return problem_; }  // why there is no factor; empty: no error
    const std::vector<std::string>& blockNames() const { return names_; }
    const Scene& scene() const { return *scene_; }
    double factorNow() const { return factor_; }  // of the run in progress
    double fractionNow() const { return fraction_; }  // of that run, 0 … 1

Q_SIGNALS:
    void changed();

private:
    void work();
    void take();

    const Document& document_;
    std::shared_ptr<const Scene> scene_;
    std::vector<std::string> names_;
    bool busy_ = false;
    std::vector<SafetyRun> runs_;
    std::optional<SafetyFactor> found_;
    QString problem_;
    std::atomic<double> factor_{1.0}, fraction_{0.0};
    Control control_;
    std::mutex mutex_;  // protects the data that the thread hands over
    std::vector<SafetyRun> newRuns_;
    std::optional<SafetyFactor> newFound_;
    std::string newProblem_;
    bool ended_ = false;
    QTimer poll_;
    std::thread thread_;
};

}  // namespace keyblock
