// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Studies in the window: a field is varied from its menu, a study file opens on its own
// tab, and a case gives the scene its values as one undo step.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/study/case_run.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/panels/properties/form_row_widget.h"
#include "ui/panels/properties/property_panel.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"
#include "ui/study/study_draft.h"
#include "ui/study/study_page.h"
#include "ui/study/study_results.h"
#include "ui/study/sweep_session.h"
#include "ui/window/main_window.h"
#include "ui/window/study_room.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class StudyRooms : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        scene_ = folder_.path() / "incline.json";
        fs::copy_file(KEYBLOCK_SAMPLES_DIR "/bolted-incline.json", scene_);
        themes_ = std::make_unique<Themes>();
        window_ = std::make_unique<MainWindow>(*themes_);
        window_->show();
        window_->openPath(qtPath(scene_));
        ASSERT_EQ(document().path(), qtPath(scene_));
    }

    static QString qtPath(const fs::path& path) { return QString::fromStdString(path.string()); }
    Document& document() { return *window_->findChild<Document*>(); }
    StudyRoom& room() { return *window_->findChild<StudyRoom*>(); }

    bool isOnTab() { return window_->findChild<QToolButton*>("workflow.6")->isChecked(); }

    /// The study of the sample with a few cases, all of them planned and none run, next to its file.
    fs::path plannedStudy(KeptStores keep = KeptStores::None) {
        const fs::path path = folder_.path() / "study.json";
        Study study = *readStudyFile(KEYBLOCK_SAMPLES_DIR "/studies/bolted-incline.json").study;
        study.scene = "incline.json";
        study.plan.cases = 6;
        study.faults.clear();
        study.keep = keep;
        writeStudyFile(path, study);
        planSweep(folder_.path() / "study-sweep-1", readStudyFile(path), "keyblock");
        return path;
    }

    test::ScratchFolder folder_;
    fs::path scene_;
    std::unique_ptr<Themes> themes_;
    std::unique_ptr<MainWindow> window_;
};

TEST_F(StudyRooms, MenuOfAFieldVariesIt) {
    window_->findChild<Selection*>()->set({"/joint_materials/joint"});
    settle();
    auto* row = window_->findChild<PropertyPanel*>()->findChild<FormRowWidget*>("row:friction_angle");
    ASSERT_TRUE(row);
    auto* line = row->findChild<QLineEdit*>();
    QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(5, 5), line->mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(line, &event);
    QAction* action = nullptr;
    for (QMenu* menu : row->findChildren<QMenu*>())
        if (QAction* found = menu->findChild<QAction*>("varyInStudy")) action = found;
    for (QMenu* menu : line->findChildren<QMenu*>())
        if (QAction* found = menu->findChild<QAction*>("varyInStudy")) action = found;
    ASSERT_TRUE(action);
    const Scene before = *document().committed();
    action->trigger();
    EXPECT_TRUE(isOnTab());
    const StudyDraft& draft = room().draft();
    ASSERT_EQ(draft.study().parameters.size(), 1u);
    EXPECT_EQ(draft.study().parameters.front().path, "joint_materials.joint.friction_angle");
    EXPECT_EQ(draft.scenePath(), qtPath(scene_));
    room().vary({"/joint_materials/joint/friction_angle"});
    EXPECT_EQ(draft.study().parameters.size(), 1u) << "a field is varied once";
    EXPECT_EQ(*document().committed(), before) << "the scene is not touched";
    room().vary({"/joint_materials/joint"});
    EXPECT_EQ(draft.study().parameters.size(), 1u) << "an object is no field";
    ASSERT_TRUE(waitFor([&] { return draft.checkIsCurrent(); }));
    window_->findChild<QToolButton*>("workflow.0")->click();
    EXPECT_FALSE(room().page()->isVisible());
}

TEST_F(StudyRooms, StudyFileOpensWithItsResults) {
    window_->openPath(qtPath(plannedStudy()));
    EXPECT_TRUE(isOnTab());
    EXPECT_EQ(room().draft().title(), "study.json");
    ASSERT_TRUE(waitFor([&] { return room().session().opened() != nullptr; }));
    EXPECT_EQ(room().session().cases(), 6);
    EXPECT_EQ(room().session().finished(), 0);
    EXPECT_TRUE(room().page()->isVisible());
    EXPECT_FALSE(window_->findChild<QDockWidget*>("timeDock")->isVisible()) << "a study has no time";
    window_->findChild<QToolButton*>("workflow.0")->click();
    EXPECT_TRUE(waitFor([&] { return window_->findChild<QDockWidget*>("problemsDock")->isVisible(); }, 5000));
}

TEST_F(StudyRooms, ResultsOfAnEarlierVersionAreShownAsSuch) {
    const fs::path path = plannedStudy();
    Study study = *readStudyFile(path).study;
    const auto opensWith = [&](const char* words) {
        writeStudyFile(path, study);
        window_->openPath(qtPath(path));
        EXPECT_TRUE(waitFor([&] { return room().session().opened() != nullptr; }, 10000));
        return window_->findChild<QLabel*>("study.detail")->text().contains(words);
    };
    study.title = "Another title";
    EXPECT_FALSE(opensWith("has changed")) << "a title changes no result";
    study.plan.seed = 2;
    EXPECT_TRUE(opensWith("has changed"));
}

TEST_F(StudyRooms, CaseGivesTheSceneItsValuesAsOneUndoStep) {
    window_->openPath(qtPath(plannedStudy()));
    ASSERT_TRUE(waitFor([&] { return room().session().opened() != nullptr; }));
    const Scene before = *document().committed();
    const Sweep sweep = openSweep(folder_.path() / "study-sweep-1");
    StudyResults& results = room().page()->results();
    const auto expected = [&](long number) { return *caseScene(sweepRunOf(sweep, 1), number).read.scene; };
    Q_EMIT results.caseWanted(3);
    EXPECT_EQ(*document().committed(), expected(3));
    EXPECT_EQ(document().undo().count(), 1);
    EXPECT_FALSE(isOnTab());
    EXPECT_FALSE(room().draft().sceneIsUnsaved()) << "values of a case are not meant for the study";
    Q_EMIT results.caseWanted(5);
    EXPECT_EQ(*document().committed(), expected(5));
    EXPECT_EQ(document().undo().count(), 2);
    document().undo().undo();
    document().undo().undo();
    EXPECT_EQ(*document().committed(), before);
}

TEST_F(StudyRooms, CaseOpensWithItsRunIfThatWasKept) {
    const fs::path path = plannedStudy(KeptStores::All);
    const Sweep sweep = openSweep(folder_.path() / "study-sweep-1");
    Control control;
    SweepCaseResult result;
    ASSERT_EQ(runCase(sweepRunOf(sweep, 1), 2, control, result), CaseEnd::Done);
    window_->openPath(qtPath(path));
    ASSERT_TRUE(waitFor([&] { return room().session().opened() != nullptr; }));
    EXPECT_EQ(room().session().finished(), 1);
    Q_EMIT room().page()->results().runWanted(2);
    ASSERT_TRUE(waitFor([&] { return window_->findChild<TimeCursor*>()->hasMoment(); }, 20000));
    settle();
    EXPECT_TRUE(window_->findChild<QToolButton*>("workflow.5")->isChecked());
    EXPECT_FALSE(room().page()->isVisible());
    EXPECT_TRUE(window_->updatesEnabled());
    const Runs& runs = *window_->findChild<Runs*>();
    ASSERT_TRUE(waitFor([&] { return !runs.entries().empty(); }));
    EXPECT_FALSE(runs.entries().front().ofEarlierScene) << "the scene in the window is that of the run";
}

TEST_F(StudyRooms, CaseDoesNotReplaceOtherUnsavedWorkWithoutAQuestion) {
    window_->openPath(qtPath(plannedStudy()));
    ASSERT_TRUE(waitFor([&] { return room().session().opened() != nullptr; }));
    Scene edited = *document().committed();
    edited.title = "my own work";
    document().apply("edit", edited);
    bool isAsked = false;
    QTimer::singleShot(100, [&isAsked] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_TRUE(box);
        isAsked = true;
        box->button(QMessageBox::Cancel)->click();
    });
    Q_EMIT room().page()->results().caseWanted(2);
    EXPECT_TRUE(isAsked);
    EXPECT_EQ(document().committed()->title, "my own work");
}

TEST_F(StudyRooms, StudyWithErrorsIsNotRun) {
    const fs::path path = plannedStudy();
    Study study = *readStudyFile(path).study;
    study.fails = "max nothing.u > 1";
    writeStudyFile(path, study);
    window_->openPath(qtPath(path));
    window_->findChild<Commands*>()->action("study.run")->trigger();
    auto* notice = window_->findChild<QLabel*>("study.notice");
    ASSERT_TRUE(waitFor([&] { return notice->isVisible(); }, 10000));
    EXPECT_TRUE(notice->text().contains("errors")) << notice->text().toStdString();
    EXPECT_FALSE(room().session().isRunning());
    EXPECT_FALSE(fs::exists(folder_.path() / "study-sweep-2"));
}

}  // namespace
}  // namespace keyblock
