// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/trade_runs.h"

#include "ui/document/document.h"
#include "ui/document/free_memory.h"
#include "ui/runs/run_problem.h"

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

constexpr int tradePollTime = 200;  // [ms]

}  // namespace

TradeRuns::TradeRuns(const Document& document, QObject* parent)
    : QObject(parent), document_(document), scene_(std::make_shared<const Scene>()) {
    connect(&poll_, &QTimer::timeout, this, &TradeRuns::take);
}

TradeRuns::~TradeRuns() { stop(); }

void TradeRuns::start() {
    if (busy_) return;
    problem_ = runProblem(document_);
    if (!problem_.isEmpty()) return Q_EMIT changed();
    scene_ = document_.committed();
    trade_ = newTrade_ = {};
    label_.clear();
    newLabel_.clear();
    fraction_ = 0.0;
    control_.stop = false;
    control_.progress = [this](const Progress& now) { fraction_ = now.fraction; };
    busy_ = true;
    measuring_.ask([this] { return measureAll(); });
    poll_.start(tradePollTime);
    Q_EMIT changed();
}

void TradeRuns::stop() { control_.stop = true; }

double TradeRuns::fraction() const {
    const double all = static_cast<double>(std::max<std::size_t>(1, trade_.planned));
    return std::min(1.0, (static_cast<double>(trade_.points.size()) + fraction_) / all);
}

bool TradeRuns::isCurrent() const { return *document_.committed() == *scene_; }

Background::Result TradeRuns::measureAll() {
    std::string problem;
    Trade trade;
    TradeSettings settings;
    settings.run = [&](const Scene& scene, const SceneCut& cut, int threads, const std::string& label, Sink& sink) {
        {
            const std::lock_guard lock(mutex_);
            newLabel_ = label;
        }
        fraction_ = 0.0;
        keyblock::run(scene, sink, control_, {threads, &cut});
    };
    settings.measured = [&](const TradePoint&) {
        const std::lock_guard lock(mutex_);
        newTrade_ = trade;
    };
    try {
        measureTrade(*scene_, settings, trade);
        const std::lock_guard lock(mutex_);
        newTrade_ = trade;
    } catch (const std::exception& error) {
        problem = error.what();
    }
    returnFreeMemory();
    return [this, problem] { finish(problem); };
}

void TradeRuns::take() {
    {
        const std::lock_guard lock(mutex_);
        trade_ = newTrade_;
        label_ = QString::fromStdString(newLabel_);
    }
    Q_EMIT changed();
}

void TradeRuns::finish(const std::string& problem) {
    poll_.stop();
    problem_ = QString::fromStdString(problem);
    busy_ = false;
    take();
    Q_EMIT ended();
}

}  // namespace keyblock
