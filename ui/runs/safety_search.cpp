// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/safety_search.h"

#include "solver/run/strength_reduction.h"
#include "solver/scene/solved_blocks.h"
#include "ui/document/document.h"
#include "ui/document/free_memory.h"
#include "ui/runs/run_problem.h"

#include <exception>

namespace keyblock {

namespace {

constexpr int pollTime = 150;  // [ms]

}  // namespace

SafetySearch::SafetySearch(const Document& document, QObject* parent)
    : QObject(parent), document_(document), scene_(std::make_shared<const Scene>()) {
    connect(&poll_, &QTimer::timeout, this, &SafetySearch::takeRuns);
}

SafetySearch::~SafetySearch() { stop(); }

void SafetySearch::start() {
    if (busy_) return;
    scene_ = document_.committed();
    runs_.clear();
    found_.reset();
    problem_ = runProblem(document_);
    if (problem_.isEmpty()) problem_ = firstError(checkSafety(*scene_));
    if (!problem_.isEmpty()) return Q_EMIT changed();
    const Checked& checked = document_.checked();
    names_ = keyblock::blockNames(checked.cut ? checked.cut->scene : *scene_);
    newRuns_.clear();
    fraction_ = 0.0;
    control_.stop = false;
    control_.progress = [this](const Progress& now) { fraction_ = now.fraction; };
    busy_ = true;
    searching_.ask([this] { return search(); });
    poll_.start(pollTime);
    Q_EMIT changed();
}

void SafetySearch::stop() { control_.stop = true; }

Background::Result SafetySearch::search() {
    std::optional<SafetyFactor> found;
    std::string problem;
    try {
        const auto trial = [this](const Scene& reduced, double factor, Sink& sink) {
            factor_ = factor;
            fraction_ = 0.0;
            keyblock::run(reduced, sink, control_);
        };
        found = findSafetyFactor(*scene_, trial, [this](const SafetyRun& run) {
            const std::lock_guard lock(mutex_);
            newRuns_.push_back(run);
        });
    } catch (const std::exception& error) {
        problem = error.what();
    }
    returnFreeMemory();
    return [this, found, problem] { finish(found, problem); };
}

void SafetySearch::takeRuns() {
    {
        const std::lock_guard lock(mutex_);
        runs_ = newRuns_;
    }
    Q_EMIT changed();
}

void SafetySearch::finish(const std::optional<SafetyFactor>& found, const std::string& problem) {
    poll_.stop();
    found_ = found;
    problem_ = QString::fromStdString(problem);
    busy_ = false;
    takeRuns();
}

}  // namespace keyblock
