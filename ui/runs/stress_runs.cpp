// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/stress_runs.h"

#include "ui/document/document.h"
#include "ui/document/free_memory.h"
#include "ui/runs/run_problem.h"

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

constexpr int stressPollTime = 200;  // [ms]

}  // namespace

StressRuns::StressRuns(const Document& document, QObject* parent)
    : QObject(parent), document_(document), scene_(std::make_shared<const Scene>()) {
    connect(&poll_, &QTimer::timeout, this, &StressRuns::take);
}

StressRuns::~StressRuns() { stop(); }

void StressRuns::start() {
    if (busy_) return;
    problem_ = runProblem(document_);
    if (!problem_.isEmpty()) return Q_EMIT changed();
    scene_ = document_.committed();
    test_ = newTest_ = {};
    label_.clear();
    newLabel_.clear();
    fraction_ = 0.0;
    planned_ = stressPushes(*scene_).size() + 1;
    control_.stop = false;
    control_.progress = [this](const Progress& now) { fraction_ = now.fraction; };
    busy_ = true;
    ended_ = false;
    pushing_.ask([this] { return pushAll(); });
    poll_.start(stressPollTime);
    Q_EMIT changed();
}

void StressRuns::stop() { control_.stop = true; }

double StressRuns::fraction() const {
    const double done = static_cast<double>(test_.points.size()) + (test_.own.values.empty() ? 0.0 : 1.0) + fraction_;
    return std::min(1.0, done / static_cast<double>(planned_));
}

bool StressRuns::isCurrent() const { return *document_.committed() == *scene_; }

Background::Result StressRuns::pushAll() {
    std::string problem;
    StressTest test;
    StressSettings settings;
    settings.run = [&](const Scene& scene, const SceneCut& cut, const std::string& label, Sink& sink) {
        {
            const std::lock_guard lock(mutex_);
            newLabel_ = label;
            newTest_ = test;
        }
        fraction_ = 0.0;
        keyblock::run(scene, sink, control_, {1, &cut});
    };
    try {
        measureStress(*scene_, settings, test);
        const std::lock_guard lock(mutex_);
        newTest_ = test;
    } catch (const std::exception& error) {
        problem = error.what();
    }
    returnFreeMemory();
    return [this, problem] { finish(problem); };
}

void StressRuns::take() {
    {
        const std::lock_guard lock(mutex_);
        test_ = newTest_;
        label_ = QString::fromStdString(newLabel_);
    }
    Q_EMIT changed();
}

void StressRuns::finish(const std::string& problem) {
    poll_.stop();
    problem_ = QString::fromStdString(problem);
    busy_ = false;
    ended_ = problem.empty();
    take();
}

}  // namespace keyblock
