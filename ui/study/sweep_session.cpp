// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/sweep_session.h"

#include "solver/files/read_error.h"
#include "solver/study/case_run.h"
#include "solver/study/sweep_status.h"
#include "ui/look/qt_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QThread>

#include <sys/prctl.h>

#include <algorithm>
#include <csignal>
#include <exception>

namespace keyblock {

namespace {

constexpr int sweepPollTime = 400;  // [ms]
constexpr long casesOfAMillisecond = 50;  // larger sweeps are read less often
constexpr int longestStop = 10000;  // [ms] at the end of the window
constexpr long mostOfATask = 50, tasksOfAProcess = 8;
constexpr int interruptedCode = 75;

/// A process that ends with the window, also if that is killed.
class CaseProcess : public QProcess {
public:
    using QProcess::QProcess;

protected:
    void setupChildProcess() override { ::prctl(PR_SET_PDEATHSIG, SIGTERM); }
};

/// Reads all that is finished; a case that cannot be read is left out, with the reason.
std::shared_ptr<OpenedSweep> openedSweep(const std::filesystem::path& folder) {
    auto opened = std::make_shared<OpenedSweep>();
    opened->sweep = openSweep(folder);
    opened->quantities = sweepRunOf(opened->sweep, 1).quantities;
    opened->results = plannedResults(opened->sweep, opened->quantities);
    for (const long number : begunCases(folder)) {
        if (number > opened->sweep.plan.cases) continue;
        try {
            readCaseInto(opened->results, opened->sweep, number);
        } catch (const CannotRead& error) {
            opened->damaged.emplace_back(error.what());
        }
    }
    makeColumns(opened->results, opened->sweep.study);
    return opened;
}

}  // namespace

SweepSession::SweepSession(QObject* parent) : QObject(parent) {
    connect(&poll_, &QTimer::timeout, this, &SweepSession::readFinished);
}

SweepSession::~SweepSession() {
    isStopping_ = true;
    queue_.clear();
    for (QProcess* process : processes_) {
        process->disconnect(this);
        process->terminate();
    }
    for (QProcess* process : processes_)
        if (!process->waitForFinished(longestStop)) {
            process->kill();
            process->waitForFinished();
        }
}

QString SweepSession::programPath() {
    const QString near = QCoreApplication::applicationDirPath() + "/keyblock";
    return QFileInfo(near).isExecutable() ? near : QStandardPaths::findExecutable("keyblock");
}

std::optional<double> SweepSession::secondsLeft() const {
    const long made = finished_ - finishedBefore_;
    if (!isRunning() || made < 1) return std::nullopt;
    return 1e-3 * static_cast<double>(since_.elapsed()) * static_cast<double>(cases() - finished_) /
           static_cast<double>(made);
}

void SweepSession::fail(const QString& why) {
    problem_ = why;
    Q_EMIT changed();
}

void SweepSession::plan(std::shared_ptr<const StudyReading> reading, const QString& folder) {
    if (isReading_ || isRunning()) return;
    if (program_.isEmpty())
        return fail(
            tr("The program keyblock, which runs the cases, was not found. Install it next to "
               "keyblock-studio."));
    isReading_ = true;
    problem_.clear();
    Q_EMIT changed();
    reading_.ask([this, reading, folder = folder.toStdString(), program = program_.toStdString()] {
        try {
            planSweep(folder, *reading, program);
            return readFolder(folder, true);
        } catch (const std::exception& error) {
            return Background::Result([this, why = QString::fromUtf8(error.what())] { take(nullptr, why, false); });
        }
    });
}

void SweepSession::open(const QString& folder, bool runs) {
    if (isRunning()) return;
    isReading_ = true;
    problem_.clear();
    Q_EMIT changed();
    reading_.ask([this, folder = folder.toStdString(), runs] { return readFolder(folder, runs); });
}

Background::Result SweepSession::readFolder(const std::string& folder, bool runs) {
    std::shared_ptr<OpenedSweep> sweep;
    QString problem;
    try {
        sweep = openedSweep(folder);
    } catch (const std::exception& error) {
        problem = QString::fromUtf8(error.what());
    }
    return [this, sweep, problem, runs] { take(sweep, problem, runs); };
}

void SweepSession::take(std::shared_ptr<OpenedSweep> sweep, const QString& problem, bool runs) {
    isReading_ = false;
    problem_ = problem;
    if (sweep) {
        opened_ = sweep;
        finished_ = sweep->results.finished();
        if (!sweep->damaged.empty()) problem_ = qt(sweep->damaged.front());
        Q_EMIT replaced();
        if (runs) run();
    }
    Q_EMIT changed();
}

void SweepSession::close() {
    if (isRunning()) return;
    opened_.reset();
    finished_ = 0;
    problem_.clear();
    Q_EMIT replaced();
    Q_EMIT changed();
}

/// The unfinished cases in groups: large ones save starts of the program, small ones keep all processes busy to the end.
void SweepSession::fillQueue() {
    queue_.clear();
    const int processes = std::max(1, QThread::idealThreadCount());
    const long most = std::clamp((cases() - finished_) / (processes * tasksOfAProcess), 1L, mostOfATask);
    for (long number = 1; number <= cases(); ++number) {
        if (opened_->results.cases[static_cast<std::size_t>(number - 1)]) continue;
        if (!queue_.empty() && queue_.back().last == number - 1 && number - queue_.back().first < most)
            queue_.back().last = number;
        else queue_.push_back({number, number});
    }
}

void SweepSession::run() {
    if (!opened_ || isRunning()) return;
    if (program_.isEmpty())
        return fail(
            tr("The program keyblock, which runs the cases, was not found. Install it next to "
               "keyblock-studio."));
    problem_.clear();
    isStopping_ = false;
    finishedBefore_ = finished_;
    since_.start();
    fillQueue();
    poll_.start(sweepPollTime + static_cast<int>(cases() / casesOfAMillisecond));
    for (int i = 0; i < std::max(1, QThread::idealThreadCount()); ++i) startNext();
    if (!isRunning()) poll_.stop();
    Q_EMIT changed();
}

void SweepSession::startNext() {
    if (queue_.empty() || isStopping_) return;
    const Task task = queue_.front();
    queue_.pop_front();
    auto* process = new CaseProcess(this);
    processes_.push_back(process);
    connect(process, &QProcess::readyReadStandardOutput, this, [this, process] { readOutput(*process); });
    connect(process, qOverload<int, QProcess::ExitStatus>(&QProcess::finished), this,
            [this, process](int code, QProcess::ExitStatus how) {
                processEnded(process, code, how == QProcess::CrashExit);
            });
    connect(process, &QProcess::errorOccurred, this, [this, process](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) processEnded(process, -1, false);
    });
    process->start(program_, {"sweep", "run", qt(opened_->sweep.folder.string()), "--index",
                              QString("%1-%2").arg(task.first).arg(task.last)});
}

/// Each line of a finished case begins with `case 17:`.
void SweepSession::readOutput(QProcess& process) {
    static const QRegularExpression line("^case (\\d+):");
    while (process.canReadLine()) {
        const auto match = line.match(QString::fromUtf8(process.readLine()));
        if (match.hasMatch()) reported_.push_back(match.captured(1).toLong());
    }
}

void SweepSession::processEnded(QProcess* process, int code, bool crashed) {
    const auto found = std::find(processes_.begin(), processes_.end(), process);
    if (found == processes_.end()) return;
    readOutput(*process);
    const QString error = QString::fromUtf8(process->readAllStandardError()).trimmed().section('\n', -1);
    const QString unstarted = process->errorString();
    processes_.erase(found);
    process->deleteLater();
    if (!isStopping_ && code != 0) {
        if (crashed) problem_ = tr("A process of the cases ended unexpectedly. Run the study again to continue.");
        else if (code < 0) problem_ = tr("The program %1 cannot be started: %2").arg(program_, unstarted);
        else problem_ = error.isEmpty() ? tr("A process of the cases ended with code %1.").arg(code) : error;
        if (code != interruptedCode) stop();  // the others would fail in the same way
    }
    startNext();
    if (isRunning()) return;
    poll_.stop();
    readFinished();
    isStopping_ = false;
    Q_EMIT changed();
    Q_EMIT ended();
}

/// Reads the summaries of cases that have finished since, and makes the columns again.
void SweepSession::readFinished() {
    if (!opened_) return;
    if (reported_.empty()) {
        if (isRunning()) Q_EMIT changed();  // the time left
        return;
    }
    auto next = std::make_shared<OpenedSweep>(*opened_);
    for (const long number : reported_) {
        if (number < 1 || number > cases()) continue;
        try {
            readCaseInto(next->results, next->sweep, number);
        } catch (const CannotRead& error) {
            problem_ = QString::fromUtf8(error.what());
        }
    }
    reported_.clear();
    makeColumns(next->results, next->sweep.study);
    finished_ = next->results.finished();
    opened_ = next;
    Q_EMIT changed();
}

void SweepSession::stop() {
    isStopping_ = true;
    queue_.clear();
    for (QProcess* process : processes_) process->terminate();
    Q_EMIT changed();
}

}  // namespace keyblock
