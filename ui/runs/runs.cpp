// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/runs.h"

#include "solver/files/read_error.h"
#include "solver/files/scene/scene_file.h"
#include "solver/results/result_names.h"
#include "ui/document/document.h"
#include "ui/runs/live_run.h"
#include "ui/runs/run_session.h"
#include "ui/runs/time_cursor.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

int numberOf(const QString& path, const QString& stem) {
    const QString name = QFileInfo(path).completeBaseName();
    if (!name.startsWith(stem + '-')) return 0;
    bool isNumber = false;
    const int number = name.mid(stem.size() + 1).toInt(&isNumber);
    return isNumber ? number : 0;
}

/// Makes the entry of a store. Reads the summary unless an earlier entry of the same file time has it already.
RunEntry entryOf(const QString& path, const QString& stem, const std::vector<RunEntry>& before) {
    RunEntry entry;
    entry.path = path;
    entry.number = numberOf(path, stem);
    entry.time = QFileInfo(path).lastModified();
    for (const RunEntry& known : before)
        if (known.path == path && known.time == entry.time && known.summary && !known.goesOn) {
            entry.summary = known.summary;
            return entry;
        }
    try {
        entry.summary = runSummary(path.toStdString());
    } catch (const std::exception& error) {
        entry.problem = QString::fromStdString(error.what());
    }
    return entry;
}

}  // namespace

QString RunEntry::name() const {
    return number > 0 ? Runs::tr("Run %1").arg(number) : QFileInfo(path).fileName();
}

QString RunEntry::outcomeText() const {
    if (goesOn) return Runs::tr("running");
    if (!summary) return Runs::tr("cannot be read");
    const QString stage = QString::fromStdString(summary->stage);
    if (!summary->outcome) return Runs::tr("interrupted in “%1”").arg(stage);
    switch (*summary->outcome) {
        case Outcome::Failed: return Runs::tr("failed in “%1”").arg(stage);
        case Outcome::Stopped: return Runs::tr("stopped in “%1”").arg(stage);
        case Outcome::Limit: return Runs::tr("limit reached in “%1”").arg(stage);
        case Outcome::Collapse: return Runs::tr("collapse in “%1”").arg(stage);
        case Outcome::Displaced: return Runs::tr("excessive movement in “%1”").arg(stage);
        case Outcome::Undecided: return Runs::tr("stability undecided in “%1”").arg(stage);
        default: return summary->resumable ? Runs::tr("interrupted after “%1”").arg(stage) : Runs::tr("finished");
    }
}

Runs::Runs(Document& document, TimeCursor& cursor, QObject* parent)
    : QObject(parent), document_(document), cursor_(cursor) {
    connect(&document, &Document::replaced, this, &Runs::leave);
    connect(&document, &Document::fileChanged, this, [this] {
        keepShown();
        refresh();
    });
    connect(&document, &Document::checkedChanged, this, &Runs::refresh);
    for (const auto signal : {&Document::changed, &Document::checkedChanged})
        connect(&document, signal, this, &Runs::sceneChanged);
    refresh();
}

Runs::~Runs() = default;

/// Called when the document is replaced. Finished runs belong to the previous document; a run in progress stays.
void Runs::leave() {
    ++documents_;
    opened_.clear();
    if (!isRunning()) {
        session_.reset();
        cursor_.setRun(nullptr, false);
        Q_EMIT sessionChanged();
    }
    Q_EMIT shownChanged();
}

/// The run that is shown stays in the list of runs, even if its store does not belong to the document's file.
void Runs::keepShown() {
    const std::vector<QString> found = stores();
    if (cursor_.run() && std::find(found.begin(), found.end(), shown()) == found.end()) opened_ = shown();
}

QString Runs::folder() const {
    if (!document_.path().isEmpty()) return QFileInfo(document_.path()).absolutePath();
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/runs";
}

QString Runs::stem() const {
    if (!document_.path().isEmpty()) return QFileInfo(document_.path()).completeBaseName();
    return document_.title().replace(QRegularExpression("[^\\w.-]+"), "-");
}

/// Stores of the document's runs, such as STEM.kbrun and STEM-1.kbrun next to a saved document, and the opened store.
std::vector<QString> Runs::stores() const {
    std::vector<QString> found;
    const QDir all(folder());
    const QString own = stem();
    for (const QString& name : all.entryList({"*.kbrun"}, QDir::Files)) {
        const QString base = QFileInfo(name).completeBaseName();
        if (base == own || numberOf(name, own) > 0) found.push_back(all.filePath(name));
    }
    if (!opened_.isEmpty() && std::find(found.begin(), found.end(), opened_) == found.end()) found.push_back(opened_);
    return found;
}

void Runs::refresh() {
    const QString going = isRunning() ? QString::fromStdString(session_->order().store.string()) : QString();
    listing_.ask([this, stores = stores(), own = stem(), before = entries_, scene = document_.committed(), going] {
        std::vector<RunEntry> entries;
        const std::string hash = sceneHash(*scene);
        for (const QString& path : stores) {
            if (path == going) {
                RunEntry entry;
                entry.path = path;
                entry.number = numberOf(path, own);
                entry.time = QDateTime::currentDateTime();
                entry.goesOn = true;
                entries.push_back(std::move(entry));
            } else {
                entries.push_back(entryOf(path, own, before));
                entries.back().ofEarlierScene = entries.back().summary && entries.back().summary->sceneHash != hash;
            }
        }
        std::stable_sort(entries.begin(), entries.end(), [](const RunEntry& a, const RunEntry& b) {
            return a.number != b.number ? a.number > b.number : a.time > b.time;
        });
        return [this, entries = std::move(entries), hash = QString::fromStdString(hash)] {
            entries_ = entries;
            documentHash_ = hash;
            Q_EMIT listChanged();
            Q_EMIT stalenessChanged();
        };
    });
}

QString Runs::staleness() const {
    if (!cursor_.run() || shownHash_.isEmpty() || documentHash_.isEmpty() || shownHash_ == documentHash_) return {};
    const QString path = shown();
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const RunEntry& e) { return e.path == path; });
    const QString name = entry == entries_.end() ? QFileInfo(path).fileName() : entry->name();
    return tr("%1 used an earlier version of the scene").arg(name);
}

QString Runs::newStore() const {
    int number = 0;
    for (const QString& path : stores()) number = std::max(number, numberOf(path, stem()));
    return QDir(folder()).filePath(QStringLiteral("%1-%2.kbrun").arg(stem()).arg(number + 1));
}

bool Runs::isRunning() const { return session_ && !session_->isOver(); }

QString Runs::nothingToRun() const {
    const Scene& scene = *document_.committed();
    if (!scene.domain && scene.blocks.empty()) return tr("Nothing to run: draw an outline or a block.");
    if (scene.stages.empty()) return tr("Nothing to run: add a stage.");
    const Checked& checked = document_.checked();
    const bool isRefused = checked.scene == document_.committed() && hasErrors(checked.problems);
    return isRefused ? tr("Fix the errors listed under Problems first.") : QString();
}

void Runs::start() {
    if (isRunning()) {
        Q_EMIT reported(tr("A run is in progress. Stop it before starting another."), true);
        return;
    }
    if (!QDir().mkpath(folder())) {
        Q_EMIT reported(
            tr("The run folder %1 cannot be created. Check that you have write permission there.").arg(folder()), true);
        return;
    }
    begin(newStore(), false);
}

void Runs::resume(const QString& store) {
    if (isRunning()) {
        Q_EMIT reported(tr("A run is in progress. Stop it before resuming another."), true);
        return;
    }
    begin(store, true);
}

void Runs::begin(const QString& store, bool resume) {
    RunOrder order;
    order.scene = document_.committed();
    // Reuses the check of the scene. If the scene has errors, the run repeats the check and reports them.
    const Checked& checked = document_.checked();
    if (checked.scene == order.scene && !hasErrors(checked.problems)) order.cut = checked.cut;
    order.store = store.toStdString();
    order.resume = resume;
    order.threads = threads_;
    session_ = std::make_unique<RunSession>(std::move(order));
    connect(session_.get(), &RunSession::began, this, [this] {
        shownHash_ = QString::fromStdString(sceneHash(*session_->order().scene));
        showRun(session_->run(), true);
        refresh();
    });
    connect(session_.get(), &RunSession::advanced, this, [this] {
        if (cursor_.run() == session_->run()) cursor_.grown();
        Q_EMIT advanced();
    });
    connect(session_.get(), &RunSession::stateChanged, this, &Runs::sessionChanged);
    connect(session_.get(), &RunSession::ended, this, &Runs::sessionEnded);
    Q_EMIT reported(resume ? tr("Resuming %1").arg(store) : tr("Running; results go to %1").arg(store), false);
    session_->start();
    Q_EMIT sessionChanged();
}

void Runs::sessionEnded() {
    if (cursor_.run() && cursor_.run() == session_->run()) cursor_.ranOut();
    if (!session_->message().isEmpty()) Q_EMIT reported(session_->message(), session_->failed());
    refresh();
    Q_EMIT sessionChanged();
}

void Runs::pauseOrGoOn() {
    if (!isRunning()) return;
    if (session_->state() == RunSession::State::Paused) session_->goOn();
    else session_->pause();
}

void Runs::step() {
    if (isRunning()) session_->step();
}

void Runs::stop() {
    if (isRunning()) session_->stop();
}

void Runs::stopForClosing() {
    session_.reset();
    Q_EMIT sessionChanged();
}

void Runs::openNewest() {
    if (isRunning()) return;  // a run in progress is shown as soon as it has a frame
    const auto newest = std::ranges::find_if(entries_, [](const RunEntry& entry) { return entry.summary.has_value(); });
    if (newest != entries_.end()) open(QString(newest->path));
}

void Runs::open(const QString& store) {
    if (isRunning() && session_->run() && store == QString::fromStdString(session_->order().store.string()))
        return showRun(session_->run(), true);
    opening_.ask([this, store, documents = documents_]() -> Background::Result {
        try {
            auto run = LiveRun::opened(store.toStdString());
            const RunSummary summary = runSummary(store.toStdString());
            return [this, documents, run = std::move(run), hash = summary.sceneHash] {
                if (documents != documents_) return;  // the document has been replaced meanwhile
                shownHash_ = QString::fromStdString(hash);
                showRun(run, false);
                keepShown();
                refresh();
            };
        } catch (const std::exception& error) {
            return [this, text = QString::fromStdString(error.what())] { Q_EMIT reported(text, true); };
        }
    });
}

void Runs::remove(const QString& store) {
    if (isRunning() && store == QString::fromStdString(session_->order().store.string())) {
        Q_EMIT reported(tr("This run is in progress. Stop it before removing it."), true);
        return;
    }
    if (shown() == store) cursor_.setRun(nullptr, false);
    QFile file(store);
    if (!file.remove()) Q_EMIT reported(tr("%1 cannot be removed: %2").arg(store, file.errorString()), true);
    for (const char* ending : {"-wal", "-shm", "-journal"}) QFile::remove(store + ending);
    if (opened_ == store) opened_.clear();
    Q_EMIT shownChanged();
    refresh();
}

QString Runs::shown() const {
    return cursor_.run() ? QString::fromStdString(cursor_.run()->store().string()) : QString();
}

void Runs::showRun(std::shared_ptr<LiveRun> run, bool goesOn) {
    cursor_.setRun(std::move(run), goesOn);
    Q_EMIT shownChanged();
    Q_EMIT stalenessChanged();
}

}  // namespace keyblock
