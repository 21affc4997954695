// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of the document: those in stores next to its file, the run in progress, and
// stores that the user opened directly. Each run has its own store; no store is
// overwritten.
#pragma once

#include "solver/files/run_store/run_summary.h"
#include "ui/document/background.h"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace keyblock {

class Document;
class LiveRun;
class RunSession;
class TimeCursor;

struct RunEntry {
    QString path;
    int number = 0;  // from the name NAME-3.kbrun; 0: the name has no number
    QDateTime time;  // when the store last changed
    std::optional<RunSummary> summary;  // none: the run is in progress, or its store cannot be read
    QString problem;  // why the store cannot be read
    bool goesOn = false;
    bool ofEarlierScene = false;

    QString name() const;  // "Run 3", or the name of the file
    QString outcomeText() const;  // e.g. "finished" or "stopped in Burst"
};

class Runs : public QObject {
    Q_OBJECT

public:
    Runs(Document& document, TimeCursor& cursor, QObject* parent = nullptr);
    ~Runs() override;

    /// The runs of the document, latest first.
    const std::vector<RunEntry>& entries() const { return entries_; }
    /// Searches for run stores again, in the background, and updates the entries.
    void refresh();

    /// Number of threads for new runs; 0: one per processor.
    void setThreads(int threads) { threads_ = threads; }

    /// The reason why the document cannot be run; empty if it can.
    QString nothingToRun() const;
    /// Starts a run of the document. If a run is in progress, reports an error instead.
    void start();
    /// Resumes an interrupted run. If a run is in progress, reports an error instead.
    /// \param store path of the run's store.
    /// \pre `RunSummary::resumable` is true and `RunEntry::ofEarlierScene` is false for this run.
    void resume(const QString& store);
    void pauseOrGoOn();
    void step();
    void stop();
    /// The run in progress, or the last one; null before the first run.
    RunSession* session() const { return session_.get(); }
    bool isRunning() const;

    /// Reads a stored run in the background, then shows it.
    void open(const QString& store);
    /// Shows the latest readable run of the document. Does nothing if there is none, or while a run is in progress.
    void openNewest();
    /// Deletes a store permanently; reports an error if this fails.
    void remove(const QString& store);
    /// Path of the store of the run shown; empty if no run is shown.
    QString shown() const;

    /// A notice such as "Run 12 used an earlier version of the scene"; empty if the run shown used the current version.
    QString staleness() const;

    /// Stops the run in progress, if any, and waits for it to finish. Results so far are kept.
    void stopForClosing();

Q_SIGNALS:
    void listChanged();
    void sessionChanged();  // a new session, or a new state of the current one
    void advanced();  // progress of the session
    void sceneChanged();  // the document was edited or checked, so that it may have become runnable or not
    void shownChanged();
    void stalenessChanged();
    void reported(const QString& message, bool isError);

private:
    void begin(const QString& store, bool resume);
    void sessionEnded();
    QString newStore() const;
    QString folder() const;
    QString stem() const;
    std::vector<QString> stores() const;
    void showRun(std::shared_ptr<LiveRun> run, bool goesOn);
    void leave();
    void keepShown();

    Document& document_;
    TimeCursor& cursor_;
    int threads_ = 0;
    std::unique_ptr<RunSession> session_;
    std::vector<RunEntry> entries_;
    QString opened_;  // store opened by the user that does not belong to the document
    int documents_ = 0;  // number of documents so far
    QString documentHash_, shownHash_;
    Background listing_, opening_;
};

}  // namespace keyblock
