// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Searches for the factor of safety of the document in the background, so that the
// window stays usable.
#pragma once

#include "solver/run/safety.h"
#include "ui/document/background.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

class Document;

class SafetySearch : public QObject {
    Q_OBJECT

public:
    explicit SafetySearch(const Document& document, QObject* parent = nullptr);
    /// Stops the search and waits for its thread.
    ~SafetySearch() override;

    /// Starts a search for the current document, unless one is in progress.
    void start();
    void stop();
    bool isBusy() const { return busy_; }

    // Results of the latest search.
    const std::vector<SafetyRun>& runs() const { return runs_; }
    const std::optional<SafetyFactor>& found() const { return found_; }  // none: the search has not finished
    const QString& problem() const { return problem_; }  // why there is no factor; empty: no error
    const std::vector<std::string>& blockNames() const { return names_; }
    const Scene& scene() const { return *scene_; }
    double factorNow() const { return factor_; }  // strength reduction factor of the run in progress
    double fractionNow() const { return fraction_; }  // completed fraction of this run, 0 … 1

Q_SIGNALS:
    void changed();

private:
    Background::Result search();
    void takeRuns();
    void finish(const std::optional<SafetyFactor>& found, const std::string& problem);

    const Document& document_;
    std::shared_ptr<const Scene> scene_;
    std::vector<std::string> names_;
    bool busy_ = false;
    std::vector<SafetyRun> runs_;
    std::optional<SafetyFactor> found_;
    QString problem_;
    std::atomic<double> factor_{1.0}, fraction_{0.0};
    Control control_;
    std::mutex mutex_;  // protects `newRuns_`, which the thread fills
    std::vector<SafetyRun> newRuns_;
    QTimer poll_;
    Background searching_;  // last member: its destructor waits for the thread, which uses the other members
};

}  // namespace keyblock
