// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Studies in the window: the commands, the page, and what connects them to the scene: a
// field is varied, a case is opened.
#pragma once

#include "ui/window/workflow.h"

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <memory>

class QMainWindow;
class QWidget;

namespace keyblock {

class Commands;
class Document;
class ReportWindow;
class Runs;
class StudyDraft;
class StudyPage;
class StudyRecovery;
class SweepSession;
class Themes;
class WorkflowBar;
struct Scene;

struct StudyRoomParts {
    QMainWindow& window;
    Commands& commands;
    Document& document;
    Runs& runs;
    const Themes& themes;
    WorkflowBar& workflow;
    ReportWindow& report;
};

class StudyRoom : public QObject {
    Q_OBJECT

public:
    explicit StudyRoom(const StudyRoomParts& parts);
    ~StudyRoom() override;

    StudyPage* page() const;
    SweepSession& session() const { return *session_; }
    StudyDraft& draft() const { return *draft_; }

    /// Opens a study file, after asking about unsaved edits of the current study.
    void open(const QString& path);
    /// Adds fields of the scene to the study of the document, and starts one if there is none.
    void vary(const QStringList& pointers);
    /// Asks about unsaved edits of the study, and whether a study that runs is stopped. False if the user cancels.
    bool mayClose();
    /// Sets the state of the workflow step Studies.
    void addTo(WorkStates& states) const;

Q_SIGNALS:
    void statesChanged();

private:
    void addCommands();
    void enableCommands();
    void showTab();
    bool mayReplace();
    bool save();
    bool saveAs();
    bool saveScene(const QString& why);
    void startNew();
    void openScene();
    void chooseFile();
    void run();
    void begin();
    void followCheck();
    void lookForSweep();
    void answerRecovery(bool recovers);
    void openCase(long number, bool withRun);
    void take(const Scene& scene, long number);
    void report();
    QString sweepFolder(int number) const;
    int lastSweep() const;
    int matchingSweep(bool ofThisBuild) const;
    void showStaleness();

    StudyRoomParts parts_;
    StudyDraft* draft_;
    SweepSession* session_;
    StudyRecovery* recovery_;
    QPointer<StudyPage> page_;
    bool runsWhenChecked_ = false, looksForSweep_ = false;
    std::shared_ptr<const Scene> lastCase_;  // scene of the case that was opened last
};

}  // namespace keyblock
