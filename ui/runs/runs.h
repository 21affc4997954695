// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs of the document: those that lie beside its file, the one that goes on, and
// stores opened by themselves. Each run has a store of its own; none is overwritten.
#pragma once

#include "solver/files/run_summary.h"
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
    std::optional<RunSummary> summary;  // none: it goes on, or cannot be read
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

    /// Threads of the runs that are started from now on; 0: as many as the machine has.
    void setThreads(int threads) { threads_ = threads; }

    /// Why a run of the document as it is would do nothing; empty: there is something to run.
    QString nothingToRun() const;
    /// Starts a run of the document, unless one goes on.
    void start();
    /// Goes on with a run that was cut short. \pre it is resumable.
    void resume(const QString& store);
    void pauseOrGoOn();
    void step();
    void stop();
    /// The run that goes on, or the last that did; null before the first.
    RunSession* session() const { return session_.get(); }
    bool isRunning() const;

    /// Shows a stored run; reads it in the background.
    void open(const QString& store);
    /// Shows the newest run of the document that can be read, where there is one and none goes on.
    void openNewest();
    /// Takes a store away for good. Tells where it cannot.
    void remove(const QString& store);
    /// Path of the store that is shown; empty: none.
    QString shown() const;

    /// "Run 12 is of an earlier scene"; empty where the run shown is of the scene as it is.
    QString staleness() const;

    /// Stops a run that goes on and waits for it; what was done is kept.
    void stopForClosing();

Q_SIGNALS:
    void listChanged();
    void sessionChanged();  // another session, or its state
    void advanced();  // of the session
    void sceneChanged();  // of the document: there may be something to run now, or nothing more
    void shownChanged();
    void stalenessChanged();
    void told(const QString& message, bool isError);

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
    QString opened_;  // a store that is none of the document's
    int documents_ = 0;  // so far
    QString documentHash_, shownHash_;
    Background listing_, opening_;
};

}  // namespace keyblock
