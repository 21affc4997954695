// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_job.h"

#include "solver/files/run_store/run_store.h"
#include "ui/export/stoppable_run.h"

#include <QCoreApplication>
#include <QThread>

#include <algorithm>
#include <array>
#include <cassert>
#include <exception>
#include <optional>

namespace keyblock {

namespace {

QString figureMessage(const QString& out, std::size_t files) {
    if (files == 2) return ExportJob::tr("Saved %1 and a CSV file next to it").arg(out);
    return files > 2 ? ExportJob::tr("Saved %1 and %2 CSV files next to it").arg(out).arg(files - 1)
                     : ExportJob::tr("Saved %1").arg(out);
}

/// A name as part of the name of a file.
std::string fileWord(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F || c == '/'; }, '_');
    return name;
}

constexpr std::array<const char*, 3> endings{".svg", ".pdf", ".png"};  // in the order of `PaperFormat`

}  // namespace

bool isThere(const RunSource& run, FigureKind kind) {
    switch (kind) {
        case FigureKind::Bolt: return !run.scene().bolts.empty() && !run.frames().empty();
        case FigureKind::Section: return true;
        case FigureKind::Curves: return !run.history().empty();
        case FigureKind::Events: return !run.events().empty();
    }
    return false;
}

ExportJob::ExportJob(QObject* parent) : QObject(parent) {}

/// Processes posted events while it waits, because the thread may be waiting for the window's thread, which is this
/// one.
ExportJob::~ExportJob() {
    stop_ = true;
    while (!ended_) {
        QCoreApplication::sendPostedEvents(qApp, 0);
        QThread::msleep(2);
    }
}

void ExportJob::start(ExportOrder order) {
    assert(!isBusy());
    stop_ = false;
    ended_ = false;
    busy_ = true;
    working_.ask([this, order = std::move(order)] { return work(order); });
}

Background::Result ExportJob::work(const ExportOrder& order) {
    QString message;
    bool isError = false;
    try {
        message = perform(order);
    } catch (const ExportStopped&) {
        message = tr("Stopped; unfinished files were removed.");
    } catch (const std::exception& error) {
        message = QString::fromUtf8(error.what());
        isError = true;
    }
    ended_ = true;
    return [this, message, isError] {
        busy_ = false;
        Q_EMIT ended(message, isError);
    };
}

QString ExportJob::perform(const ExportOrder& order) {
    const RunStore store(order.store);
    const StoppableRun run(store, stop_);
    const QString out = QString::fromStdString(order.out.string());
    switch (order.what) {
        case ExportWhat::Figure: return figureMessage(out, paint(run, order.figure, order.withData, order.out));
        case ExportWhat::Numbers:
            writeTableFile(run, order.table, order.figure.filter, order.out);
            return tr("Saved %1").arg(out);
        case ExportWhat::Film:
            writeFilm(run, order.figure, order.perSecond, order.out, stop_,
                      [this](std::size_t done, std::size_t all) { tell(tr("Frames"), done, all); });
            return tr("Saved %1").arg(out);
        case ExportWhat::Everything:
            return tr("%1 files saved to %2").arg(exportEverything(run, order)).arg(out);
    }
    return {};
}

/// Charts are widgets, so they are painted in the window's thread.
std::size_t ExportJob::paint(const RunSource& run, const FigureRequest& request, bool withData,
                             const std::filesystem::path& out) {
    std::size_t written = 0;
    const auto write = [&] { written = writeFigureFiles(run, request, withData, out).size(); };
    if (hasCharts(request.kind)) inWindow(write);
    else write();
    return written;
}

std::size_t ExportJob::exportEverything(const RunSource& run, const ExportOrder& order) {
    std::filesystem::create_directories(order.out);
    TableFilter moment = order.figure.filter;
    moment.bolt.reset();
    std::size_t written = exportFigures(run, order), tried = 0;
    for (const std::string_view word : tableWords()) {
        if (stop_) throw ExportStopped();
        tell(tr("Tables"), ++tried, std::size(tableWords()));
        const TableKind kind = *tableKindOf(word);
        if (hasBolts(kind) && run.scene().bolts.empty()) continue;
        writeTableFile(run, kind, isOfFrame(kind) ? moment : TableFilter(), order.out / (order.figure.runName + "-" + std::string(word) + ".csv"));
        ++written;
    }
    return written;
}

std::size_t ExportJob::exportFigures(const RunSource& run, const ExportOrder& order) {
    std::size_t written = 0, tried = 0;
    const std::size_t all = 3 + run.scene().bolts.size();
    const auto add = [&](FigureKind kind, const std::string& name, std::optional<int> bolt) {
        if (stop_) throw ExportStopped();
        tell(tr("Figures"), ++tried, all);
        if (!isThere(run, kind)) return;
        FigureRequest request = order.figure;
        request.kind = kind;
        if (kind != FigureKind::Section) request.quantity.reset();
        if (kind == FigureKind::Curves) request.filter = {};  // curves always cover the whole run
        request.filter.bolt = bolt;
        const std::string ending = endings[static_cast<std::size_t>(request.format)];
        written += paint(run, request, false, order.out / (request.runName + "-" + name + ending));
    };
    add(FigureKind::Section, "section", {});
    add(FigureKind::Curves, "curves", {});
    add(FigureKind::Events, "events", {});
    for (std::size_t i = 0; i < run.scene().bolts.size(); ++i)
        add(FigureKind::Bolt, "bolt-" + fileWord(run.scene().bolts[i].name), static_cast<int>(i));
    return written;
}

void ExportJob::tell(const QString& what, std::size_t done, std::size_t all) {
    QMetaObject::invokeMethod(this, [=, this] { Q_EMIT advanced(what, int(done), int(all)); }, Qt::QueuedConnection);
}

/// Runs a task in the window's thread. Exceptions of the task are rethrown here.
void ExportJob::inWindow(const std::function<void()>& task) {
    std::exception_ptr thrown;
    QMetaObject::invokeMethod(qApp, [&] {
        try {
            if (!stop_) task();
        } catch (...) {
            thrown = std::current_exception();
        }
    }, Qt::BlockingQueuedConnection);
    if (thrown) std::rethrow_exception(thrown);
    if (stop_) throw ExportStopped();
}

}  // namespace keyblock
