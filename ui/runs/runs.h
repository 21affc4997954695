// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of the document: those next to its file, the one in progress, and stores
// opened directly. Each run has its own store; none is overwritten.
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
    int number = 0;  // as in NAME-3.kbrun; 0: the store has none
    QDateTime time;  // of the last change
    std::optional<RunSummary> summary;  // none: it is in progress, or cannot be read
    QString problem;  // why it cannot be read
    bool goesOn = false;
    bool ofEarlierScene = false;

    QString name() const;  // "Run 3", or the name of the file
    QString outcomeText() const;  // "finished", "stopped in Burst", …
};

class Runs : public QObject {
    Q_OBJECT

public:
    Runs(Document& document, TimeCursor& cursor, QObject* parent = nullptr);
    ~Runs() override;

    /// The document's runs, the newest first.
    const std::vector<RunEntry>& entries() const { return entries_; }
    /// Looks for stores again.
    void refresh();

    /// Number of threads for new runs; 0: as many as the machine has.
    void setThreads(int threads) { threads_ = threads; }

    /// Why the document cannot be run; empty: it can.
    QString nothingToRun() const;
    /// Starts a run of the document, unless one is in progress.
    void start();
    /// Resumes an interrupted run. \pre it is resumable.
    void resume(const QString& store);
    void pauseOrGoOn();
    void step();
    void stop();
    /// The run in progress, or the last one; null before the first.
    RunSession* session() const { return session_.get(); }
    bool isRunning() const;

    /// Shows a stored run; reads it in the background.
    void open(const QString& store);
    /// Shows the newest readable run of the document, if there is one and none is in progress.
    void openNewest();
    /// Deletes a store permanently. Reports an error if that fails.
    void remove(const QString& store);
    /// Path of the store shown; empty: none.
    QString shown() const;

    /// "Run 12 used an earlier version of the scene"; empty if the run shown is of the current scene.
    QString staleness() const;

    /// Stops a run in progress and waits for it; results so far are kept.
    void stopForClosing();

Q_SIGNALS:
    void listChanged();
    void sessionChanged();  // another session, or a new state of it
    void advanced();  // progress of the session
    void sceneChanged();  // the document was edited: it may have become runnable, or not runnable
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
    QString opened_;  // a store that does not belong to the document
    int documents_ = 0;  // number so far
    QString documentHash_, shownHash_;
    Background listing_, opening_;
};

}  // namespace keyblock
