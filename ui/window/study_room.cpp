// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/study_room.h"

#include "solver/files/read_error.h"
#include "solver/files/run_store/build_id.h"
#include "solver/files/sha256.h"
#include "solver/run/write_error.h"
#include "solver/study/case_run.h"
#include "ui/document/document.h"
#include "ui/document/file_folder.h"
#include "ui/edit/defaults.h"
#include "ui/export/report_window.h"
#include "ui/look/ask_path.h"
#include "ui/look/commands.h"
#include "ui/look/question.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/runs/runs.h"
#include "ui/study/study_draft.h"
#include "ui/study/study_form.h"
#include "ui/study/study_page.h"
#include "ui/study/study_problems.h"
#include "ui/study/study_recovery.h"
#include "ui/study/study_results.h"
#include "ui/study/sweep_session.h"
#include "ui/study/variation.h"
#include "ui/window/file_commands.h"
#include "ui/window/workflow_bar.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMainWindow>
#include <QStandardPaths>
#include <QStatusBar>

#include <algorithm>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

constexpr int studyMessageTime = 8000;  // [ms]

/// Whether a sweep was planned from this study and scene. Titles, and where the files are, do not matter.
bool isOf(const Sweep& sweep, const StudyReading& reading) {
    if (!reading.partly || sweep.plan.sceneHash != sha256(reading.sceneText)) return false;
    Study study = *reading.partly;
    study.scene = sweep.study.scene;
    study.title = sweep.study.title;
    return study == sweep.study;
}

}  // namespace

StudyRoom::StudyRoom(const StudyRoomParts& parts)
    : QObject(&parts.window), parts_(parts), draft_(new StudyDraft(parts.document, this)),
      session_(new SweepSession(this)), recovery_(new StudyRecovery(*draft_, studyRecoveryFolder(), this)) {
    addCommands();
    page_ = new StudyPage(*draft_, *session_, parts.commands, parts.themes, &parts.window);
    connect(&page_->results(), &StudyResults::caseWanted, this, [this](long number) { openCase(number, false); });
    connect(&page_->results(), &StudyResults::runWanted, this, [this](long number) { openCase(number, true); });
    connect(page_, &StudyPage::recoveryAnswered, this, &StudyRoom::answerRecovery);
    connect(draft_, &StudyDraft::replaced, this, [this] {
        session_->close();
        looksForSweep_ = draft_->isOpen();
    });
    connect(draft_, &StudyDraft::changed, this, [this] {
        page_->setNotice({});
        enableCommands();
    });
    connect(draft_, &StudyDraft::checkedChanged, this, &StudyRoom::followCheck);
    connect(session_, &SweepSession::replaced, this, &StudyRoom::showStaleness);
    connect(session_, &SweepSession::changed, this, [this] {
        enableCommands();
        Q_EMIT statesChanged();
    });
    if (const auto lost = recovery_->lost()) page_->offerRecovery(lost->title());
    enableCommands();
}

/// The page and the recovery use the study until they end.
StudyRoom::~StudyRoom() {
    delete page_;
    delete recovery_;
}

StudyPage* StudyRoom::page() const { return page_; }

void StudyRoom::addCommands() {
    const auto add = [this](const char* id, const QString& text, const char* icon, const QString& help,
                            void (StudyRoom::*what)()) {
        parts_.commands.add({id, text, "Run", icon, help, {}, false, "study"}, [this, what] { (this->*what)(); });
    };
    add("study.show", tr("Studies"), "", tr("Shows the study: what varies, the cases and their results."),
        &StudyRoom::showTab);
    add("study.new", tr("New study"), "", tr("Starts a study, which runs the scene with many values."),
        &StudyRoom::startNew);
    add("study.open", tr("Open study…"), "", tr("Opens a study file and its results."), &StudyRoom::chooseFile);
    parts_.commands.add(
        {"study.save", tr("Save study"), "Run", "", tr("Saves the study to its file."), {}, false, "study"},
        [this] { save(); });
    parts_.commands.add(
        {"study.saveAs", tr("Save study as…"), "Run", "", tr("Saves the study to another file."), {}, false, "study"},
        [this] { saveAs(); });
    add("study.run", tr("Run study"), "play",
        tr("Runs all cases that are not finished, with one process for each processor."), &StudyRoom::run);
    parts_.commands.add({"study.stop",
                         tr("Stop study"),
                         "Run",
                         "stop",
                         tr("Stops the cases; finished ones are kept and the others can be resumed."),
                         {},
                         false,
                         "study"},
                        [this] { session_->stop(); });
    add("study.report", tr("Report of study…"), "", tr("Makes a report of the finished cases as PDF or HTML."),
        &StudyRoom::report);
}

void StudyRoom::enableCommands() {
    Commands& commands = parts_.commands;
    const QString none = draft_->isOpen() ? QString() : tr("No study is open.");
    const bool isBusy = session_->isRunning() || session_->isReading();
    for (const char* id : {"study.save", "study.saveAs"}) commands.setWhyNot(id, none);
    commands.setWhyNot("study.run", !none.isEmpty() ? none : isBusy ? tr("The study is running already.") : QString());
    commands.setWhyNot("study.stop", session_->isRunning() ? QString() : tr("No study is running."));
    commands.setWhyNot("study.report", session_->opened() && session_->finished() > 0
                                           ? QString()
                                           : tr("No case has finished yet. Run the study first."));
}

void StudyRoom::showTab() {
    parts_.workflow.choose(WorkStep::Studies);
    page_->setFocus();
}

void StudyRoom::addTo(WorkStates& states) const {
    WorkState& state = states[static_cast<std::size_t>(WorkStep::Studies)];
    if (session_->isRunning()) state = WorkState::Running;
    else if (!session_->problem().isEmpty()) state = WorkState::Error;
    else if (session_->opened() && session_->finished() == session_->cases()) state = WorkState::Done;
}

/// Whether another study may be opened in place of this one.
bool StudyRoom::mayReplace() {
    finishTyping();
    if (session_->isRunning()) {
        ask(parts_.window, tr("Studies"), tr("A study is running. Stop it first."), {}, {{QMessageBox::Ok, {}}});
        return false;
    }
    if (!draft_->isModified()) return true;
    const auto answer = ask(parts_.window, tr("Unsaved edits"), tr("%1 has unsaved edits.").arg(draft_->title()), {},
                            {{QMessageBox::Save, {}}, {QMessageBox::Discard, {}}, {QMessageBox::Cancel, {}}});
    if (answer == QMessageBox::Discard) recovery_->discard();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool StudyRoom::mayClose() {
    finishTyping();
    if (session_->isRunning()) {
        const auto answer = ask(parts_.window, tr("Studies"), tr("A study is running. Stop it and quit?"),
                                tr("Finished cases are kept, and the others can be resumed."),
                                {{QMessageBox::Yes, tr("Stop and quit")}, {QMessageBox::Cancel, {}}});
        if (answer != QMessageBox::Yes) return false;
        session_->stop();
    }
    if (!draft_->isModified()) return true;
    const auto answer = ask(parts_.window, tr("Unsaved edits"), tr("%1 has unsaved edits.").arg(draft_->title()), {},
                            {{QMessageBox::Save, {}}, {QMessageBox::Discard, {}}, {QMessageBox::Cancel, {}}});
    if (answer == QMessageBox::Discard) recovery_->discard();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

bool StudyRoom::save() {
    if (!draft_->isOpen()) return false;
    if (draft_->path().isEmpty()) return saveAs();
    try {
        draft_->save(draft_->path());
        return true;
    } catch (const CannotWrite& error) {
        ask(parts_.window, tr("Save study"), tr("The study was not saved."), QString::fromUtf8(error.what()),
            {{QMessageBox::Ok, {}}});
        return false;
    }
}

bool StudyRoom::saveAs() {
    const QFileInfo scene(draft_->scenePath());
    const QString start = draft_->path().isEmpty()
                              ? scene.absolutePath() + '/' + scene.completeBaseName() + "-study.json"
                              : draft_->path();
    const QString path = askSavePath(parts_.window, tr("Save study"), start, tr("Studies (*.json)"), "json");
    if (path.isEmpty()) return false;
    if (QFileInfo(path) == scene) {
        ask(parts_.window, tr("Save study"), tr("%1 is the scene of the study.").arg(scene.fileName()),
            tr("Choose another name."), {{QMessageBox::Ok, {}}});
        return false;
    }
    try {
        draft_->save(path);
        looksForSweep_ = true;
        return true;
    } catch (const CannotWrite& error) {
        ask(parts_.window, tr("Save study"), tr("The study was not saved."), QString::fromUtf8(error.what()),
            {{QMessageBox::Ok, {}}});
        return false;
    }
}

/// Saves the document, which a study reads from its file. \return whether it is in a file now
bool StudyRoom::saveScene(const QString& why) {
    const auto answer = ask(parts_.window, tr("Save scene"), why, {},
                            {{QMessageBox::Save, tr("Save scene")}, {QMessageBox::Cancel, {}}});
    if (answer != QMessageBox::Save) return false;
    parts_.commands.action("file.save")->trigger();
    return !parts_.document.path().isEmpty() && !parts_.document.isModified();
}

void StudyRoom::startNew() {
    if (!mayReplace()) return;
    if (parts_.document.path().isEmpty() && !saveScene(tr("A study needs the scene in a file. Save the scene first?")))
        return;
    draft_->startNew(parts_.document.path());
    showTab();
}

void StudyRoom::chooseFile() {
    const QString path = QFileDialog::getOpenFileName(&parts_.window, tr("Open study"), fileFolder(parts_.document),
                                                      tr("Studies (*.json)"));
    if (!path.isEmpty()) open(path);
}

void StudyRoom::open(const QString& path) {
    if (!mayReplace()) return;
    const QString why = draft_->open(path);
    if (!why.isEmpty()) {
        ask(parts_.window, tr("Open study"), tr("%1 cannot be opened.").arg(QFileInfo(path).fileName()), why,
            {{QMessageBox::Ok, {}}});
        return;
    }
    openScene();
    showTab();
    page_->showSetup();
}

/// Opens the scene of the study if the window has no scene yet.
void StudyRoom::openScene() {
    Document& document = parts_.document;
    const Scene& shown = *document.committed();
    const bool isEmpty = document.path().isEmpty() && !document.isModified() &&
                         (shown == Scene{} || shown == newScene());
    if (isEmpty && QFileInfo(draft_->scenePath()).isFile()) document.open(draft_->scenePath());
}

void StudyRoom::vary(const QStringList& pointers) {
    const Document& document = parts_.document;
    std::vector<std::string> fields;
    for (const QString& pointer : pointers) fields.push_back(pointer.toStdString());
    const std::optional<StudyParameter> suggestion = variationOf(*document.committed(), fields);
    if (!suggestion)
        return parts_.window.statusBar()->showMessage(tr("A study cannot vary this field."), studyMessageTime);
    if (document.path().isEmpty() && !saveScene(tr("A study needs the scene in a file. Save the scene first?"))) return;
    if (!draft_->isOpen() || !draft_->isOfDocument()) {
        if (!mayReplace()) return;
        draft_->startNew(document.path());
    }
    Study study = draft_->study();
    auto found = std::find_if(study.parameters.begin(), study.parameters.end(),
                              [&](const StudyParameter& one) { return one.path == suggestion->path; });
    if (found == study.parameters.end()) found = study.parameters.insert(found, *suggestion);
    const std::string pointer = "/parameters/" + std::to_string(found - study.parameters.begin());
    draft_->change(std::move(study));
    showTab();
    page_->showSetup();
    page_->form().reveal(pointer + (suggestion->distribution ? "/distribution/mean" : "/values"));
}

QString StudyRoom::sweepFolder(int number) const {
    const QFileInfo study(draft_->path());
    QString folder = study.absolutePath();
    if (!QFileInfo(folder).isWritable())
        folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/studies";
    return QStringLiteral("%1/%2-sweep-%3").arg(folder, study.completeBaseName()).arg(number);
}

/// The largest number of a sweep of this study; 0: none.
int StudyRoom::lastSweep() const {
    const QFileInfo first(sweepFolder(1));
    const QString start = first.fileName().chopped(1);
    int last = 0;
    for (const QString& name : first.dir().entryList({start + '*'}, QDir::Dirs))
        last = std::max(last, name.mid(start.size()).toInt());
    return last;
}

/// The latest sweep of the study as it is now; 0: none. Other builds of the program cannot continue it.
int StudyRoom::matchingSweep(bool ofThisBuild) const {
    const auto reading = draft_->checked();
    if (!reading || draft_->path().isEmpty()) return 0;
    for (int number = lastSweep(); number > 0; --number) try {
            const Sweep sweep = openSweep(sweepFolder(number).toStdString());
            if (isOf(sweep, *reading) && (!ofThisBuild || sweep.plan.build == buildId())) return number;
        } catch (const CannotRead&) {
            continue;  // not a sweep
        }
    return 0;
}

void StudyRoom::run() {
    if (draft_->sceneIsUnsaved() &&
        !saveScene(tr("The scene has unsaved edits, and the study uses its file. Save the scene?")))
        return;
    if ((draft_->isModified() || draft_->path().isEmpty()) && !save()) return;
    runsWhenChecked_ = true;
    if (draft_->checkIsCurrent()) followCheck();
}

void StudyRoom::followCheck() {
    if (!draft_->checkIsCurrent()) return;
    showStaleness();
    if (std::exchange(runsWhenChecked_, false)) return begin();
    if (std::exchange(looksForSweep_, false)) lookForSweep();
}

void StudyRoom::showStaleness() {
    const auto reading = draft_->checked();
    const auto sweep = session_->opened();
    page_->results().setStale(reading && sweep && !isOf(sweep->sweep, *reading));
}

/// Runs the study, which has been checked: continues a sweep of the same study and scene, or plans a new one.
void StudyRoom::begin() {
    looksForSweep_ = false;
    const auto reading = draft_->checked();
    if (!reading->study) {
        page_->showSetup();
        return page_->setNotice(tr("The study has errors. Correct them, then run it."));
    }
    page_->showResults();
    const int same = matchingSweep(true);
    if (same == 0) return session_->plan(reading, sweepFolder(lastSweep() + 1));
    const bool isShown = session_->opened() && session_->opened()->sweep.folder == sweepFolder(same).toStdString();
    if (isShown && session_->finished() == session_->cases())
        return page_->setNotice(tr("All cases are finished. Change the study to run others."));
    if (isShown) return session_->run();
    session_->open(sweepFolder(same), true);
}

/// Reads the results that the study has already, or those of its latest version.
void StudyRoom::lookForSweep() {
    if (session_->isRunning() || draft_->path().isEmpty()) return;
    const int same = matchingSweep(false), last = lastSweep();
    if (same > 0) page_->showResults();
    const QString folder = sweepFolder(same > 0 ? same : last);
    if (last > 0 && QFileInfo::exists(folder + '/' + sweepPlanName)) session_->open(folder);
}

void StudyRoom::answerRecovery(bool recovers) {
    if (const auto lost = recovery_->lost()) {
        if (recovers && !mayReplace()) return;
        if (recovers) recovery_->recover(*lost);
        else recovery_->remove(*lost);
    }
    const auto next = recovery_->lost();
    page_->offerRecovery(next ? next->title() : QString());
}

/// Shows the scene of a case, and its run if that is wanted and was kept.
void StudyRoom::openCase(long number, bool withRun) {
    const auto sweep = session_->opened();
    if (!sweep || number < 1 || number > session_->cases()) return;
    QApplication::setOverrideCursor(Qt::WaitCursor);
    QString why;
    SceneReading read;
    try {
        read = caseScene(sweepRunOf(sweep->sweep, 1), number).read;
        for (const Problem& problem : read.problems)
            if (problem.severity == Severity::Error && why.isEmpty()) why = sentenceOf(problem);
    } catch (const std::exception& error) {
        why = QString::fromUtf8(error.what());
    }
    QApplication::restoreOverrideCursor();
    if (!read.scene) {
        ask(parts_.window, tr("Open case"), tr("Case %1 has no valid scene.").arg(number), why,
            {{QMessageBox::Ok, {}}});
        return;
    }
    const fs::path store = caseFolder(sweep->sweep.folder, number) / "run.kbrun";
    if (!(*parts_.document.committed() == *read.scene)) {
        const bool isBase = lastCase_ && *parts_.document.committed() == *lastCase_;
        const SceneReading base = isBase ? SceneReading{}
                                         : readSceneText(sweep->sweep.sceneText, sweepSceneName, {}, std::nullopt);
        if (isBase || (base.scene && *base.scene == *parts_.document.committed())) {
            take(*read.scene, number);
        } else {
            if (!mayDiscard(parts_.document, parts_.window)) return;
            const QString stem = QFileInfo(draft_->path()).completeBaseName();
            parts_.document.startNew(*read.scene, tr("%1 case %2").arg(stem).arg(number));
        }
    }
    lastCase_ = parts_.document.committed();
    draft_->showsCase(lastCase_);
    if (withRun) parts_.runs.open(qt(store.string()));
    else parts_.workflow.choose(WorkStep::Geometry);
}

void StudyRoom::take(const Scene& scene, long number) {
    parts_.document.apply(tr("use the values of case %1").arg(number), scene);
    parts_.window.statusBar()->showMessage(
        tr("The scene has the values of case %1. Undo restores its own.").arg(number), studyMessageTime);
}

void StudyRoom::report() {
    const auto sweep = session_->opened();
    if (!sweep) return;
    const fs::path& folder = sweep->sweep.folder;
    parts_.report.open({folder, ReportKind::Study, folder.parent_path() / (folder.filename().string() + "-report")});
}

}  // namespace keyblock
