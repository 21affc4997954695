// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/run_session.h"

#include "solver/files/run_store/resumption.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/run_store_writer.h"
#include "solver/results/run_source.h"
#include "solver/results/result_names.h"
#include "solver/scene/check.h"
#include "solver/scene/collapse_stage.h"
#include "ui/document/free_memory.h"
#include "ui/runs/live_run.h"

#include <pthread.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

namespace keyblock {

namespace {

constexpr int interval = 33;  // [ms] between two reads of the feed
constexpr int niceness = 5;  // leaves a third of a processor to the run if the window is busy
constexpr double leastFraction = 0.005;  // smallest fraction for which the remaining time is estimated

/// Keeps the window responsive while a run uses every processor. Threads started from this one inherit the priority.
void giveWayToTheWindow() { ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), niceness); }

/// Requires a scene that can be run. \throws std::runtime_error with the first error.
void requireRunnable(const Scene& scene, std::optional<SceneCut>& cut) {
    if (scene.stages.empty())
        throw std::runtime_error("the scene has no stages, so there is nothing to run; add a stage");
    const std::vector<Problem> problems = checkScene(scene, &cut);
    const auto errors = std::count_if(problems.begin(), problems.end(),
                                      [](const Problem& problem) { return problem.severity == Severity::Error; });
    if (errors == 0) return;
    const auto first = std::find_if(problems.begin(), problems.end(),
                                    [](const Problem& problem) { return problem.severity == Severity::Error; });
    throw std::runtime_error("the scene has " + std::string(errors == 1 ? "an error" : "errors") + ": " +
                             oneLine(*first));
}

}  // namespace

RunSession::RunSession(RunOrder order, QObject* parent) : QObject(parent), order_(std::move(order)) {
    timer_.setInterval(interval);
    connect(&timer_, &QTimer::timeout, this, &RunSession::takeFeed);
}

RunSession::~RunSession() {
    control_.stop = true;
    if (thread_.joinable()) thread_.join();
}

void RunSession::start() {
    if (thread_.joinable() || isOver()) return;
    clock_.start();
    timer_.start();
    control_.progress = [this](const Progress& progress) { feed_.progress(progress); };
    control_.looked = [this](const Frame& frame) { feed_.look(frame); };
    looked_.start();
    thread_ = std::thread([this] {
        giveWayToTheWindow();
        work(ending_);
        returnFreeMemory();
        QMetaObject::invokeMethod(this, &RunSession::finish, Qt::QueuedConnection);
    });
}

/// Turns every exception into a message, so that the thread always ends normally.
void RunSession::work(Ending& ending) {
    try {
        runIt(ending);
    } catch (const std::bad_alloc&) {
        ending.problem = tr("There is not enough memory for this run. Use fewer blocks or bolt divisions.");
    } catch (const std::exception& error) {
        ending.problem = QString::fromStdString(error.what());
    } catch (...) {
        ending.problem = tr("The run ended unexpectedly.");
    }
}

void RunSession::runIt(Ending& ending) {
    const Scene& scene = *order_.scene;
    std::optional<SceneCut> own;
    const SceneCut* cut = order_.cut.get();
    if (!cut) {
        requireRunnable(scene, own);
        cut = own ? &*own : nullptr;
    }
    const auto solved = std::make_shared<const Scene>(withCollapseStages(cut ? cut->scene : scene));
    const Resumption from = order_.resume ? resumptionOf(order_.store, scene) : Resumption{};
    ending.nothingToDo = from.finished;
    if (from.finished) return;
    if (from.checkpoint) {
        const RunStore kept(order_.store);
        feed_.start(solved, kept.columns());
        feed_.earlier(kept, &*from.checkpoint);
    }
    RunStoreWriter store(order_.store, order_.resume);
    LiveSink sink(store, feed_, solved);
    ending.stages = keyblock::run(scene, sink, control_, {order_.threads, cut},
                                 from.checkpoint ? &*from.checkpoint : nullptr);
    store.close();
}

void RunSession::pause() {
    if (state_ != State::Running) return;
    control_.pause = true;
    pausedSince_ = clock_.elapsed();
    setState(State::Paused);
}

void RunSession::goOn() {
    if (state_ != State::Paused) return;
    paused_ += clock_.elapsed() - pausedSince_;
    control_.steps = 0;
    control_.pause = false;
    setState(State::Running);
}

void RunSession::step() {
    pause();
    if (state_ == State::Paused) ++control_.steps;
}

void RunSession::setLooksPerSecond(int looks) {
    looks_ = std::max(0, looks);
    if (looks_ == 0) control_.look = false;
}

double RunSession::threadSeconds() const {
    clockid_t clock{};
    timespec time{};
    if (!thread_.joinable() || isOver() || ::pthread_getcpuclockid(thread_.native_handle(), &clock) != 0 ||
        ::clock_gettime(clock, &time) != 0)
        return 0.0;
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void RunSession::stop() {
    if (isOver() || state_ == State::Stopping) return;
    control_.stop = true;
    setState(State::Stopping);
}

void RunSession::takeFeed() {
    LiveBatch batch = feed_.take();
    const bool isNew = batch.start.has_value();
    const bool any = isNew || batch.newest.frame || batch.progress || !batch.stagesBegun.empty() ||
                     !batch.stagesEnded.empty() || !batch.frames.empty() || !batch.events.empty();
    if (isNew) run_ = std::make_shared<LiveRun>(order_.store, *batch.start);
    if (looks_ > 0 && looked_.elapsed() >= 1000 / looks_ - interval / 2) {
        control_.look = true;
        looked_.start();
    }
    if (batch.progress && !startFraction_) startFraction_ = batch.progress->fraction;
    if (run_) run_->append(std::move(batch));
    if (isNew) {
        if (state_ == State::Preparing) setState(State::Running);
        Q_EMIT began();
    }
    if (any && run_) Q_EMIT advanced();
}

void RunSession::finish() {
    if (thread_.joinable()) thread_.join();
    timer_.stop();
    takeFeed();
    tellEnding();
    setState(State::Ended);
    Q_EMIT ended();
}

void RunSession::tellEnding() {
    const QString kept = tr("Results so far are saved in %1.").arg(QString::fromStdString(order_.store.string()));
    if (!ending_.stages.empty()) outcome_ = ending_.stages.back().outcome;
    if (!ending_.problem.isEmpty()) {
        failed_ = true;
        message_ = ending_.problem;
        if (run_ && !run_->frames().empty()) message_ += QStringLiteral(" ") + kept;
        return;
    }
    if (ending_.nothingToDo) {
        message_ = tr("This run has already finished.");
        return;
    }
    if (ending_.stages.empty()) return;
    const StageResult& last = ending_.stages.back();
    const QString name = QString::fromStdString(stageTitle(*order_.scene, last.stage));
    const QString why = QString::fromStdString(last.message);
    switch (last.outcome) {
        case Outcome::Failed:
            failed_ = true;
            message_ = tr("The run failed in %1: %2. %3").arg(name, why, kept);
            break;
        case Outcome::Stopped: message_ = tr("The run was stopped in %1. %2").arg(name, kept); break;
        case Outcome::Limit: message_ = tr("The run ended in %1: %2. %3").arg(name, why, kept); break;
        case Outcome::Collapse: message_ = tr("Collapse in %1 (%2).").arg(name, why); break;
        case Outcome::Displaced: message_ = tr("Excessive movement in %1 (%2).").arg(name, why); break;
        case Outcome::Undecided: message_ = tr("Stability could not be determined in %1: %2. %3").arg(name, why, kept); break;
        default: message_ = finishedMessage(); break;
    }
}

/// A stage before the last may have been unstable, or blocks may still be falling in a stage that reached its duration.
QString RunSession::finishedMessage() const {
    for (const StageResult& result : ending_.stages) {
        if (result.unstable.empty()) continue;
        return tr("The run is finished, but the section is not stable in %1 (%2).")
            .arg(QString::fromStdString(stageTitle(*order_.scene, result.stage)), QString::fromStdString(result.message));
    }
    return tr("The run is finished.");
}

bool RunSession::isUnstable() const {
    return isOver() && std::any_of(ending_.stages.begin(), ending_.stages.end(),
                                   [](const StageResult& result) { return !result.unstable.empty(); });
}

double RunSession::fraction() const {
    if (isOver() && outcome_ && !failed_ && (endedAsPlanned(*outcome_) || endedUnstable(*outcome_))) return 1.0;
    return run_ && run_->progress() ? std::clamp(run_->progress()->fraction, 0.0, 1.0) : 0.0;
}

std::optional<double> RunSession::secondsLeft() const {
    if (!startFraction_ || isOver()) return std::nullopt;
    const double done = fraction() - *startFraction_;
    if (done < leastFraction) return std::nullopt;
    const qint64 until = state_ == State::Paused ? pausedSince_ : clock_.elapsed();
    return 1e-3 * static_cast<double>(until - paused_) * (1.0 - fraction()) / done;
}

QString RunSession::stageText() const {
    if (!run_) return tr("Preparing");
    const int stage = run_->progress() ? run_->progress()->stage : 0;
    const QString at = tr("Stage %1 of %2").arg(stage + 1).arg(run_->scene().stages.size());
    const std::string name = stageName(run_->scene(), stage);
    const bool says = name == "stage " + std::to_string(stage + 1);  // default name: it only repeats the number
    return says ? at : tr("%1 · %2").arg(at, QString::fromStdString(name));
}

QString RunSession::searchText() const {
    if (!run_ || !run_->progress() || isOver()) return {};
    return QString::fromStdString(keyblock::searchText(run_->progress()->step, run_->blockNames()));
}

long RunSession::steps() const { return run_ && run_->progress() ? run_->progress()->steps : 0; }

void RunSession::setState(State state) {
    state_ = state;
    Q_EMIT stateChanged();
}

QString leftText(double seconds) {
    if (seconds < 90.0) return RunSession::tr("%1 s left").arg(std::max(1L, std::lround(seconds)));
    const long minutes = std::lround(std::min(seconds, 3.6e6) / 60.0);
    if (minutes < 90) return RunSession::tr("%1 min left").arg(minutes);
    return RunSession::tr("%1 h %2 min left").arg(minutes / 60).arg(minutes % 60);
}

}  // namespace keyblock
