// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study runs by the program of the command line, is stopped and continued, and its cases
// are shown and opened.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "solver/study/case_run.h"
#include "ui/look/theme.h"
#include "ui/study/study_results.h"
#include "ui/study/sweep_session.h"
#include "ui/study/sweep_view.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <gtest/gtest.h>

#include <sstream>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class Sweeps : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        session_.setProgram(KEYBLOCK_PROGRAM);
    }

    /// The sample with this number of cases.
    static std::shared_ptr<const StudyReading> study(int cases) {
        const fs::path path = fs::path(KEYBLOCK_SAMPLES_DIR) / "studies/bolted-incline.json";
        Study study = *readStudyFile(path).study;
        study.plan.cases = cases;
        return std::make_shared<const StudyReading>(readStudyText(studyText(study), path));
    }

    QString sweepPath() const { return QString::fromStdString((folder_.path() / "sweep").string()); }

    bool hasEnded() {
        return waitFor([&] { return !session_.isRunning() && !session_.isReading(); }, 30000);
    }

    static std::string table(const SweepSession& session) {
        std::ostringstream text;
        writeResultsTable(session.opened()->results, session.opened()->sweep.study, text);
        return text.str();
    }

    test::ScratchFolder folder_;
    Themes themes_;
    SweepSession session_;
};

TEST_F(Sweeps, FinishedStudyHasTheResultsOfTheCommandLine) {
    session_.plan(study(12), sweepPath());
    ASSERT_TRUE(waitFor([&] { return session_.isRunning(); }));
    ASSERT_TRUE(hasEnded());
    EXPECT_EQ(session_.problem().toStdString(), "");
    EXPECT_EQ(session_.finished(), 12);
    const Sweep sweep = openSweep(sweepPath().toStdString());
    std::ostringstream serial;
    writeResultsTable(collectResults(sweep, sweepRunOf(sweep, 1).quantities), sweep.study, serial);
    EXPECT_EQ(table(session_), serial.str());
    SweepSession again;
    again.open(sweepPath());
    ASSERT_TRUE(waitFor([&] { return again.opened() != nullptr; }));
    EXPECT_EQ(again.finished(), 12);
    EXPECT_EQ(table(again), serial.str());
}

TEST_F(Sweeps, StoppedStudyKeepsItsCasesAndContinues) {
    session_.plan(study(400), sweepPath());
    ASSERT_TRUE(waitFor([&] { return session_.finished() > 0; }, 30000));
    session_.stop();
    QElapsedTimer time;
    time.start();
    ASSERT_TRUE(hasEnded());
    EXPECT_LT(time.elapsed(), 5000);
    const long before = session_.finished();
    ASSERT_GT(before, 0);
    ASSERT_LT(before, 400) << "the study ended before it was stopped";
    EXPECT_EQ(session_.problem().toStdString(), "");
    session_.run();
    ASSERT_TRUE(waitFor([&] { return session_.finished() > before; }, 30000));
    session_.stop();
    ASSERT_TRUE(hasEnded());
}

TEST_F(Sweeps, ProgramThatIsMissingOrFailsIsReported) {
    session_.setProgram("/no/such/program");
    session_.plan(study(3), sweepPath());
    ASSERT_TRUE(waitFor([&] { return !session_.problem().isEmpty(); }, 10000));
    EXPECT_TRUE(session_.problem().contains("/no/such/program")) << session_.problem().toStdString();
    ASSERT_TRUE(hasEnded());
    session_.setProgram("/bin/false");
    session_.run();
    ASSERT_TRUE(hasEnded());
    EXPECT_FALSE(session_.problem().isEmpty());
    session_.open(sweepPath() + "-none");
    ASSERT_TRUE(hasEnded());
    EXPECT_TRUE(session_.problem().contains("plan.json")) << session_.problem().toStdString();
}

TEST_F(Sweeps, DotsAndRowsOpenTheirCases) {
    StudyResults results(session_, themes_);
    results.resize(900, 700);
    results.show();
    session_.plan(study(40), sweepPath());
    ASSERT_TRUE(waitFor([&] { return session_.isRunning(); }));
    ASSERT_TRUE(hasEnded());
    ASSERT_EQ(session_.finished(), 40);
    EXPECT_TRUE(results.findChild<QLabel*>("study.answer")->text().startsWith("Probability of failure:"));
    auto* kind = results.findChild<QComboBox*>("study.chart");
    kind->setCurrentIndex(1);
    Q_EMIT kind->activated(1);
    settle();
    auto* chart = results.findChild<SweepView*>("sweepView");
    const auto place = chart->placeOf(17);
    ASSERT_TRUE(place);
    QSignalSpy wanted(&results, &StudyResults::caseWanted);
    QTest::mouseClick(chart, Qt::LeftButton, {}, *place);
    ASSERT_GT(results.selectedCase(), 0);
    EXPECT_LE((*chart->placeOf(results.selectedCase()) - *place).manhattanLength(), 14);
    EXPECT_EQ(wanted.count(), 0) << "one click only selects";
    auto* table = results.findChild<QTableView*>("study.cases");
    EXPECT_EQ(table->currentIndex().row() + 1, results.selectedCase());
    results.findChild<QPushButton*>("study.openCase")->click();
    ASSERT_EQ(wanted.count(), 1);
    EXPECT_EQ(wanted.front().front().toLongLong(), results.selectedCase());
    EXPECT_FALSE(results.findChild<QPushButton*>("study.openRun")->isEnabled()) << "the study keeps no runs";
    table->sortByColumn(2, Qt::AscendingOrder);
    const double first = table->model()->index(0, 2).data(Qt::UserRole).toDouble();
    const double last = table->model()->index(39, 2).data(Qt::UserRole).toDouble();
    EXPECT_LT(first, last);
}

TEST_F(Sweeps, SceneOfACaseHasItsValue) {
    session_.plan(study(5), sweepPath());
    ASSERT_TRUE(waitFor([&] { return session_.isRunning(); }));
    ASSERT_TRUE(hasEnded());
    const SweepResults& results = session_.opened()->results;
    const SweepColumn* angle = findColumn(results, "friction_angle_deg");
    ASSERT_TRUE(angle);
    const CaseScene scene = caseScene(sweepRunOf(session_.opened()->sweep, 1), 4);
    ASSERT_TRUE(scene.read.scene);
    EXPECT_NEAR(scene.read.scene->jointMaterials.front().second.frictionAngle, angle->values[3], 1e-12);
}

}  // namespace
}  // namespace keyblock
