// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window when documents are replaced: everything shown belongs to the open one, and
// no file is overwritten without asking.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/panels/library/library_panel.h"
#include "ui/panels/properties/form_row_widget.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class Documents : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        themes_ = std::make_unique<Themes>();
        window_ = std::make_unique<MainWindow>(*themes_);
        window_->show();
        document_ = window_->findChild<Document*>();
        canvas_ = window_->findChild<Canvas*>();
    }

    /// Opens a copy, so that its runs are stored next to the copy.
    void open(const std::string& sample) {
        const fs::path copy = folder_.path() / (sample + ".json");
        fs::copy_file(fs::path(KEYBLOCK_SAMPLES_DIR) / (sample + ".json"), copy, fs::copy_options::overwrite_existing);
        window_->openPath(QString::fromStdString(copy.string()));
        ASSERT_TRUE(waitFor([&] { return document_->checkIsCurrent() && document_->checked().picture; }));
    }

    void run() {
        Runs& runs = *window_->findChild<Runs*>();
        runs.start();
        ASSERT_TRUE(waitFor([&] { return !runs.isRunning(); }, 60000));
        ASSERT_TRUE(window_->findChild<TimeCursor*>()->hasMoment());
    }

    QString stateOf(const char* tab) { return window_->findChild<QToolButton*>(tab)->accessibleDescription(); }

    test::ScratchFolder folder_;
    std::unique_ptr<Themes> themes_;
    std::unique_ptr<MainWindow> window_;
    Document* document_ = nullptr;
    Canvas* canvas_ = nullptr;
};

TEST_F(Documents, OpeningAnotherSceneWhileResultsAreShownFitsItWithoutARun) {
    open("incline");
    EXPECT_EQ(stateOf("workflow.4"), "not started");
    run();
    EXPECT_EQ(stateOf("workflow.4"), "done");
    open("drift-bolted");
    const Box about = document_->checked().picture->window;
    ASSERT_TRUE(waitFor([&] { return canvas_->picture() && canvas_->picture()->blocks.size() > 10; }));
    const Box seen = canvas_->map().window();
    EXPECT_TRUE((seen.min.array() <= about.min.array()).all() && (seen.max.array() >= about.max.array()).all());
    EXPECT_LT((seen.max - seen.min).minCoeff(), 2.0 * (about.max - about.min).maxCoeff());
    EXPECT_EQ(stateOf("workflow.4"), "not started");
    EXPECT_FALSE(window_->findChild<Runs*>()->session());
}

TEST_F(Documents, ASceneWithErrorsIsFittedToWhatIsDrawn) {
    std::ifstream in(fs::path(KEYBLOCK_SAMPLES_DIR) / "incline.json");
    nlohmann::json scene = nlohmann::json::parse(in);
    for (auto& material : scene["materials"]) material["density"] = -1.0;
    for (auto& block : scene["blocks"])
        for (auto& point : block["points"]) point[0] = point[0].get<double>() + 500.0;
    const fs::path path = folder_.path() / "faulty.json";
    std::ofstream(path) << scene;
    window_->openPath(QString::fromStdString(path.string()));
    ASSERT_TRUE(waitFor([&] { return document_->checkIsCurrent() && hasErrors(document_->checked().problems); }));
    for (const auto& block : scene["blocks"])
        for (const auto& point : block["points"]) {
            const Point corner(point[0].get<double>(), point[1].get<double>());
            EXPECT_TRUE(meets(canvas_->map().window(), {corner, corner})) << point;
        }
}

TEST_F(Documents, ResultsShowTheNewestRunWhenNoneWasChosen) {
    open("incline");
    run();
    open("drift-bolted");
    open("incline");
    const TimeCursor& cursor = *window_->findChild<TimeCursor*>();
    const Runs& runs = *window_->findChild<Runs*>();
    ASSERT_TRUE(waitFor([&] { return !runs.entries().empty() && runs.entries().front().summary; }));
    EXPECT_FALSE(cursor.hasMoment());
    window_->findChild<QToolButton*>("workflow.5")->click();
    EXPECT_TRUE(waitFor([&] { return cursor.hasMoment(); }));
    EXPECT_EQ(runs.shown(), runs.entries().front().path);
}

TEST_F(Documents, ValuesAtTheCursorAreShownOverTheSectionOnly) {
    open("drift-bolted");
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    auto* under = window_->findChild<QLabel*>("status.under");
    canvas_->zoomTo(canvas_->picture()->model);
    const Point block = moments(canvas_->picture()->blocks.front().outline).centroid;
    QTest::mouseMove(canvas_, {5, 5});
    QTest::mouseMove(canvas_, canvas_->map().toPixel(block).toPoint());
    EXPECT_TRUE(waitFor([&] { return !under->text().isEmpty(); }));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(canvas_, &leave);
    EXPECT_TRUE(under->text().isEmpty()) << under->text().toStdString();
}

/// Answers questions until it is destroyed.
struct Answers : QObject {
    int asked = 0;
};

/// Cancels the question that appears.
void cancelQuestion(Answers& answers) {
    QTimer::singleShot(0, &answers, [&answers] {
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!question) return cancelQuestion(answers);
        ++answers.asked;
        question->button(QMessageBox::Cancel)->click();
    });
}

/// Answers the file dialog with a name, and cancels the question after it.
void answerWith(const QString& name, Answers& answers) {
    QTimer::singleShot(0, &answers, [=, &answers] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (!dialog) return answerWith(name, answers);
        dialog->findChild<QLineEdit*>("fileNameEdit")->setText(name);
        cancelQuestion(answers);
        QMetaObject::invokeMethod(dialog, "accept");
    });
}

TEST_F(Documents, ABoltLinksToItsTypeInTheSceneOrInTheLibrary) {
    auto* selection = window_->findChild<Selection*>();
    const auto follow = [&] {
        selection->set({"/bolts/0"});
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // rows of the previous selection
        auto* row = window_->findChild<FormRowWidget*>("row:type");
        auto* arrow = row ? row->findChild<QToolButton*>("target") : nullptr;
        ASSERT_TRUE(arrow && arrow->isEnabled());
        arrow->click();
    };
    open("burst-rebar");
    follow();
    EXPECT_EQ(selection->pointers(), QStringList{"/bolt_types/brittle"});
    open("rebar-20");
    follow();
    EXPECT_EQ(selection->pointers(), QStringList{"/bolts/0"});
    EXPECT_EQ(window_->findChild<LibraryPanel*>()->chosen(), "rebar-20");
    EXPECT_TRUE(window_->findChild<LibraryPanel*>()->isVisible());
}

/// Presses a button of the question that appears, and returns its title.
void pressWhenAsked(QMessageBox::StandardButton button, QString& title) {
    QTimer::singleShot(0, [=, &title] {
        auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!question) return pressWhenAsked(button, title);
        title = question->windowTitle();
        question->button(button)->click();
    });
}

TEST_F(Documents, RevertReadsTheSavedFileAgain) {
    open("incline");
    QAction* revert = window_->findChild<Commands*>()->action("file.revert");
    EXPECT_FALSE(revert->isEnabled());
    const Scene saved = *document_->scene();
    Scene edited = saved;
    edited.title = "Edited";
    document_->apply("Set title", edited);
    EXPECT_TRUE(revert->isEnabled());
    QString title;
    pressWhenAsked(QMessageBox::Cancel, title);
    revert->trigger();
    EXPECT_EQ(document_->scene()->title, "Edited");
    pressWhenAsked(QMessageBox::Discard, title);
    revert->trigger();
    EXPECT_EQ(title, "Revert to saved");
    EXPECT_EQ(*document_->scene(), saved);
    EXPECT_FALSE(document_->isModified() || revert->isEnabled());
}

TEST_F(Documents, OpenAsksAboutUnsavedEditsBeforeAFileIsChosen) {
    open("incline");
    Scene edited = *document_->scene();
    edited.title = "Edited";
    document_->apply("Set title", edited);
    QString title;
    pressWhenAsked(QMessageBox::Cancel, title);
    window_->findChild<Commands*>()->action("file.open")->trigger();  // does not wait for a file
    EXPECT_EQ(title, "Unsaved edits");
    EXPECT_EQ(document_->scene()->title, "Edited");
}

TEST_F(Documents, SavingANameWithoutExtensionAsksBeforeItOverwrites) {
    open("incline");
    const fs::path other = folder_.path() / "other.json";
    test::putContent(other, "mine");
    Answers answers;
    answerWith(QString::fromStdString((folder_.path() / "other").string()), answers);
    window_->findChild<Commands*>()->action("file.saveAs")->trigger();
    EXPECT_EQ(answers.asked, 1);
    EXPECT_EQ(test::contentOf(other), "mine");
    EXPECT_TRUE(document_->path().endsWith("incline.json"));
}

}  // namespace
}  // namespace keyblock
