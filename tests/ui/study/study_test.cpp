// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study is made, checked, saved and recovered; fields of a scene become values that
// vary, and every choice of values gives a valid study.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/study/study_draft.h"
#include "ui/study/study_form.h"
#include "ui/study/study_problems.h"
#include "ui/study/study_recovery.h"
#include "ui/study/study_values.h"
#include "ui/study/variation.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <QTreeWidget>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

const std::string frictionPointer = "/joint_materials/joint/friction_angle";

class Studies : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        scene_ = folder_.path() / "incline.json";
        fs::copy_file(KEYBLOCK_SAMPLES_DIR "/bolted-incline.json", scene_);
        ASSERT_TRUE(document_.open(qtPath(scene_)).empty());
        draft_.startNew(qtPath(scene_));
    }

    static QString qtPath(const fs::path& path) { return QString::fromStdString(path.string()); }

    bool isChecked() {
        return waitFor([&] { return draft_.checked() && draft_.checkIsCurrent(); });
    }

    StudyParameter friction() { return variationOf(*document_.committed(), {frictionPointer}).value(); }

    void add(const StudyParameter& parameter) {
        Study study = draft_.study();
        study.parameters.push_back(parameter);
        draft_.change(study);
    }

    test::ScratchFolder folder_;
    fs::path scene_;
    Themes themes_;
    Document document_;
    StudyDraft draft_{document_};
};

TEST_F(Studies, SuggestionForANumberIsANormalDistributionAroundItsValue) {
    const StudyParameter parameter = friction();
    EXPECT_EQ(parameter.path, "joint_materials.joint.friction_angle");
    ASSERT_TRUE(parameter.distribution);
    const double value = document_.committed()->jointMaterials.front().second.frictionAngle;
    EXPECT_EQ(parameter.distribution->kind, DistributionKind::Normal);
    EXPECT_EQ(parameter.distribution->mean, value);
    EXPECT_NEAR(*parameter.distribution->deviation, 0.1 * value, 0.005 * value);
}

TEST_F(Studies, ItemsOfListsAreNamedInPathsAndChoicesAreListed) {
    const Scene& scene = *document_.committed();
    ASSERT_EQ(scene.bolts.front().name, "B");
    EXPECT_EQ(studyPathOf(scene, "/bolts/0/divisions"), "bolts.B.divisions");
    const auto plate = variationOf(scene, {"/bolts/0/plate"});
    ASSERT_TRUE(plate);
    EXPECT_GT(plate->values.size(), 1u);
    EXPECT_EQ(plate->values.front().front(), '"') << "texts of choices are JSON";
    EXPECT_FALSE(variationOf(scene, {"/bolts/0/name"})) << "a name is no value";
    EXPECT_FALSE(variationOf(scene, {"/blocks/0/outline"}));
    EXPECT_FALSE(variationOf(scene, {}));
}

TEST_F(Studies, EveryChoiceOfValuesGivesAValidStudy) {
    for (int choice = 0; choice + 1 < valueChoices().size(); ++choice) {  // the last one is for seeds only
        StudyParameter parameter = friction();
        choose(parameter, static_cast<ValueChoice>(choice));
        EXPECT_EQ(choiceOf(parameter), static_cast<ValueChoice>(choice));
        Study study = draft_.study();
        study.parameters = {parameter};
        draft_.change(study);
        ASSERT_TRUE(isChecked());
        for (const Problem& problem : draft_.checked()->problems)
            EXPECT_NE(problem.severity, Severity::Error) << valuesText(parameter).toStdString() << oneLine(problem);
    }
}

TEST_F(Studies, TypedNumbersReachTheStudyAndWrongOnesStayInTheField) {
    StudyForm form(draft_, themes_);
    form.resize(800, 900);
    form.show();
    add(friction());
    auto* row = form.findChild<QWidget*>("studyRow:/parameters/0/distribution/mean");
    ASSERT_TRUE(row);
    auto* line = row->findChild<QLineEdit*>();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, "41,5");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(draft_.study().parameters.front().distribution->mean, 41.5);
    line->selectAll();
    QTest::keyClicks(line, "forty");
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(draft_.study().parameters.front().distribution->mean, 41.5);
    EXPECT_EQ(line->text(), "forty");
    EXPECT_TRUE(row->findChild<QLabel*>("studyProblem")->isVisible());
}

TEST_F(Studies, ErrorsAreShownAtTheirFieldAndInTheList) {
    StudyForm form(draft_, themes_);
    form.resize(800, 900);
    form.show();
    Study study = draft_.study();
    study.parameters.push_back(friction());
    study.fails = "max nothing.u > 1";
    draft_.change(study);
    ASSERT_TRUE(isChecked());
    EXPECT_EQ(errorsIn(draft_.checked()->problems), 1);
    const auto* problem = form.findChild<QWidget*>("studyRow:/fails")->findChild<QLabel*>("studyProblem");
    EXPECT_TRUE(problem->isVisible());
    EXPECT_TRUE(problem->text().contains("nothing")) << problem->text().toStdString();
    auto* list = form.findChild<QListWidget*>("study.problems");
    ASSERT_EQ(list->count(), 1);
    study.fails = "not stands";
    draft_.change(study);
    ASSERT_TRUE(isChecked());
    EXPECT_FALSE(problem->isVisible());
    EXPECT_EQ(list->count(), 0);
}

TEST_F(Studies, AnotherDistributionShowsItsOwnFields) {
    StudyForm form(draft_, themes_);
    form.resize(800, 900);
    form.show();
    add(friction());
    const auto shows = [&](const char* field) {
        const auto* row = form.findChild<QWidget*>(QString("studyRow:/parameters/0/distribution/") + field);
        return row && row->isVisible();
    };
    EXPECT_TRUE(shows("mean"));
    EXPECT_FALSE(shows("peak"));
    auto* kind = form.findChild<QComboBox*>("study.values");
    kind->setCurrentIndex(static_cast<int>(ValueChoice::Triangular));
    Q_EMIT kind->activated(kind->currentIndex());
    EXPECT_FALSE(shows("mean"));
    EXPECT_TRUE(shows("peak"));
    EXPECT_EQ(draft_.study().parameters.front().distribution->kind, DistributionKind::Triangular);
}

TEST_F(Studies, SavedStudyIsTheFileThatTheCommandLineReads) {
    add(friction());
    const fs::path path = folder_.path() / "below" / "study.json";
    fs::create_directory(path.parent_path());
    draft_.save(qtPath(path));
    EXPECT_FALSE(draft_.isModified());
    EXPECT_EQ(draft_.study().scene, "../incline.json");
    const StudyReading reading = readStudyFile(path);
    for (const Problem& problem : reading.problems) ADD_FAILURE() << oneLine(problem);
    ASSERT_TRUE(reading.study);
    EXPECT_EQ(*reading.study, draft_.study());
}

TEST_F(Studies, FileOfWhichValuesAreNotReadIsNotOverwritten) {
    const fs::path path = folder_.path() / "study.json";
    test::putContent(path, R"({ "format": "keyblock-study", "version": 1, "scene": "incline.json", "walues": 3 })");
    EXPECT_EQ(draft_.open(qtPath(path)).toStdString(), "");
    EXPECT_TRUE(draft_.path().isEmpty());
    test::putContent(path, "no study");
    EXPECT_FALSE(draft_.open(qtPath(path)).isEmpty());
}

TEST_F(Studies, UnsavedStudyOfAnEndedProgramIsRecovered) {
    const QString kept = qtPath(folder_.path() / "unsaved");
    add(friction());
    const Study before = draft_.study();
    {
        StudyRecovery recovery(draft_, kept);
        Q_EMIT draft_.changed();
        EXPECT_FALSE(recovery.lost()) << "a program does not recover from itself";
    }
    const fs::path own = fs::path(kept.toStdString()) / (std::to_string(QCoreApplication::applicationPid()) + ".json");
    ASSERT_TRUE(fs::exists(own));
    fs::rename(own, fs::path(kept.toStdString()) / "4194999.json");  // a process that does not exist
    draft_.close();
    StudyRecovery recovery(draft_, kept);
    const auto lost = recovery.lost();
    ASSERT_TRUE(lost);
    recovery.recover(*lost);
    EXPECT_TRUE(draft_.isModified());
    EXPECT_EQ(draft_.study(), before);
    EXPECT_EQ(draft_.scenePath(), qtPath(scene_));
    EXPECT_FALSE(recovery.lost());
    draft_.save(qtPath(folder_.path() / "study.json"));
    EXPECT_TRUE(fs::is_empty(kept.toStdString())) << "a saved study needs no recovery";
}

}  // namespace
}  // namespace keyblock
