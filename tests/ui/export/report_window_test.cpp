// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports made in the window have the bytes of those of the command line; chosen sections
// are kept in a template with which the report can be made again.
#include "tests/scratch_folder.h"
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"

#include "ui/export/report_window.h"
#include "ui/report/stored/stored_report.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class ReportWindowTest : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        store_ = folder_.path() / "slide.kbrun";
        test::slidingRun(store_, 0.02);
        window_ = std::make_unique<ReportWindow>(nullptr);
        window_->open({store_, ReportKind::Run, folder_.path() / "slide"});
        line("report.project")->setText("Level 840");
        line("report.author")->setText("A. Engineer");
        line("report.date")->setText("2026-01-31");
    }

    QLineEdit* line(const char* name) { return window_->findChild<QLineEdit*>(name); }
    QListWidget* sections() { return window_->findChild<QListWidget*>("report.sections"); }
    QString message() { return window_->findChild<QLabel*>("report.message")->text(); }

    void chooseFormat(int index) {
        auto* format = window_->findChild<QComboBox*>("report.format");
        format->setCurrentIndex(index);
        Q_EMIT format->activated(index);
    }

    void create() {
        auto* button = window_->findChild<QPushButton*>("report.create");
        ASSERT_TRUE(button->isEnabled());
        button->click();
        ASSERT_TRUE(waitFor([&] { return button->isEnabled(); }, 20000));
    }

    /// Answers the next question.
    void answer(QMessageBox::StandardButton button) {
        QTimer::singleShot(50, [button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            ASSERT_TRUE(box);
            box->button(button)->click();
        });
    }

    ReportOrder sameOrder(const fs::path& out) const {
        return {store_, out, {}, "Level 840", "A. Engineer", "2026-01-31", {}, {}};
    }

    test::ScratchFolder folder_;
    fs::path store_;
    std::unique_ptr<ReportWindow> window_;
};

TEST_F(ReportWindowTest, ReportHasTheBytesOfTheCommandLine) {
    chooseFormat(1);
    const fs::path out = folder_.path() / "slide.html";
    EXPECT_EQ(line("report.out")->text().toStdString(), out.string());
    create();
    EXPECT_TRUE(message().startsWith("Saved")) << message().toStdString();
    EXPECT_EQ(test::contentOf(out), reportFile(sameOrder(out)).bytes);
    EXPECT_FALSE(fs::exists(folder_.path() / "slide-template.txt")) << "no section was left out";
}

TEST_F(ReportWindowTest, ExistingFileIsReplacedOnlyAfterAQuestion) {
    chooseFormat(1);
    const fs::path out = folder_.path() / "slide.html";
    test::putContent(out, "mine");
    answer(QMessageBox::Cancel);
    window_->findChild<QPushButton*>("report.create")->click();
    EXPECT_EQ(test::contentOf(out), "mine");
    answer(QMessageBox::Yes);
    create();
    EXPECT_TRUE(test::contentOf(out).starts_with("<!DOCTYPE html>"));
    line("report.out")->setText(QString::fromStdString(store_.string()));
    window_->findChild<QPushButton*>("report.create")->click();  // as slide.kbrun.html
    EXPECT_TRUE(waitFor([&] { return window_->findChild<QPushButton*>("report.create")->isEnabled(); }, 20000));
    EXPECT_TRUE(fs::exists(store_.string() + ".html")) << message().toStdString();
}

TEST_F(ReportWindowTest, ChosenSectionsAndTheirOrderAreKeptInATemplate) {
    chooseFormat(1);
    const int count = sections()->count();
    ASSERT_EQ(count, static_cast<int>(defaultTemplate(ReportKind::Run).sections.size()));
    for (int i = 3; i < count; ++i) sections()->item(i)->setCheckState(Qt::Unchecked);
    sections()->setCurrentRow(1);
    window_->findChild<QPushButton*>("report.up")->click();
    EXPECT_EQ(sections()->currentRow(), 0);
    create();
    const fs::path out = folder_.path() / "slide.html", layout = folder_.path() / "slide-template.txt";
    EXPECT_EQ(test::contentOf(layout), "[sections]\n\n[summary]\n\n[model]\n");
    ReportOrder again = sameOrder(out);
    again.layout = layout;
    EXPECT_EQ(test::contentOf(out), reportFile(again).bytes);
    for (int i = 0; i < count; ++i) sections()->item(i)->setCheckState(Qt::Unchecked);
    EXPECT_FALSE(window_->findChild<QPushButton*>("report.create")->isEnabled()) << "a report has sections";
}

/// Lines of the form are evenly spaced while there is no problem with the template.
TEST_F(ReportWindowTest, FormHasNoGap) {
    window_->show();
    settle();
    const auto top = [&](const char* name) { return line(name)->mapTo(window_.get(), QPoint()).y(); };
    EXPECT_EQ(top("report.logo") - top("report.template"), top("report.out") - top("report.logo"));
}

TEST_F(ReportWindowTest, WrongTemplateAndMissingLogoAreReported) {
    chooseFormat(1);
    test::putContent(folder_.path() / "wrong.txt", "[boltz]\n");
    line("report.template")->setText(QString::fromStdString((folder_.path() / "wrong.txt").string()));
    Q_EMIT line("report.template")->editingFinished();
    const auto* problem = window_->findChild<QLabel*>("report.templateProblem");
    EXPECT_TRUE(problem->text().contains("boltz")) << problem->text().toStdString();
    line("report.template")->clear();
    Q_EMIT line("report.template")->editingFinished();
    EXPECT_TRUE(problem->text().isEmpty());
    line("report.logo")->setText(QString::fromStdString((folder_.path() / "none.png").string()));
    create();
    EXPECT_TRUE(message().contains("none.png")) << message().toStdString();
    EXPECT_FALSE(fs::exists(folder_.path() / "slide.html"));
}

TEST_F(ReportWindowTest, StoppedReportLeavesNoFile) {
    window_->findChild<QPushButton*>("report.create")->click();
    window_->findChild<QPushButton*>("report.stop")->click();
    ASSERT_TRUE(waitFor([&] { return window_->findChild<QPushButton*>("report.create")->isEnabled(); }, 20000));
    EXPECT_TRUE(message().startsWith("Stopped")) << message().toStdString();
    EXPECT_FALSE(fs::exists(folder_.path() / "slide.pdf"));
}

}  // namespace
}  // namespace keyblock
