// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/report_job.h"

#include "solver/files/atomic_file.h"
#include "solver/files/kept_files.h"
#include "ui/look/qt_text.h"
#include "ui/report/stored/sweep_figures.h"

#include <QCoreApplication>
#include <QThread>

#include <cassert>
#include <exception>
#include <filesystem>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

struct ReportStopped {};

}  // namespace

ReportJob::ReportJob(QObject* parent) : QObject(parent) {}

/// Processes posted events while it waits, because the thread may be waiting for the window's thread, which is this
/// one.
ReportJob::~ReportJob() {
    stop_ = true;
    while (!ended_) {
        QCoreApplication::sendPostedEvents(qApp, 0);
        QThread::msleep(2);
    }
}

void ReportJob::start(ReportTask task) {
    assert(!isBusy());
    stop_ = false;
    ended_ = false;
    busy_ = true;
    working_.ask([this, task = std::move(task)] { return work(task); });
}

Background::Result ReportJob::work(ReportTask task) {
    QString message;
    bool isError = true, isWritten = false;
    try {
        message = perform(task);
        isError = false;
        isWritten = true;
    } catch (const ReportStopped&) {
        message = tr("Stopped; no report was written.");
        isError = false;
    } catch (const std::exception& error) {
        message = QString::fromUtf8(error.what());
    }
    ended_ = true;
    return [this, message, isError, isWritten] {
        busy_ = false;
        Q_EMIT ended(message, isError, isWritten);
    };
}

QString ReportJob::perform(ReportTask& task) {
    ReportOrder& order = task.order;
    std::vector<fs::path> sources{order.source};
    if (order.layout && task.templateText.empty()) sources.push_back(*order.layout);
    requireReplaceable(order.out, sources);
    if (!task.templateText.empty()) {
        requireReplaceable(*order.layout, sources);
        writeAtomically(*order.layout, [&](std::ostream& out) { out << task.templateText; });
    }
    if (fs::is_directory(order.source)) {
        advance(tr("Figures of the study").toStdString(), 0.0);
        collectSweep(order.source);  // its report shows these figures
    }
    order.progress = [this](const std::string& heading, double done) { advance(heading, done); };
    order.draw = [this](const std::function<void()>& paint) { inWindow(paint); };
    const ReportFile file = reportFile(order);
    if (stop_) throw ReportStopped();
    writeAtomically(order.out, [&](std::ostream& out) { out << file.bytes; });
    QString message = tr("Saved %1").arg(qt(order.out.string()));
    if (!task.templateText.empty()) message += tr(" and its template %1").arg(qt(order.layout->filename().string()));
    return file.warning.empty() ? message : message + ". " + tr("Warning: %1").arg(qt(file.warning));
}

void ReportJob::advance(const std::string& heading, double done) {
    if (stop_) throw ReportStopped();
    const QString what = heading.empty() ? tr("Writing") : qt(heading);
    QMetaObject::invokeMethod(
        this, [this, what, done] { Q_EMIT advanced(what, done); }, Qt::QueuedConnection);
}

/// Runs a task in the window's thread. Exceptions of the task are rethrown here.
void ReportJob::inWindow(const std::function<void()>& task) {
    std::exception_ptr thrown;
    QMetaObject::invokeMethod(
        qApp,
        [&] {
            try {
                if (!stop_) task();
            } catch (...) {
                thrown = std::current_exception();
            }
        },
        Qt::BlockingQueuedConnection);
    if (thrown) std::rethrow_exception(thrown);
    if (stop_) throw ReportStopped();
}

}  // namespace keyblock
