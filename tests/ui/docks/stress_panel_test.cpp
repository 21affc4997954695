// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stress test in the window: the runs, Stop, the answer and the list.
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"
#include "ui/docks/stress_panel.h"
#include "ui/document/document.h"
#include "ui/runs/stress_runs.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

class StressPanelTest : public ::testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        panel_ = std::make_unique<StressPanel>(runs_);
        panel_->resize(700, 320);
        panel_->show();
    }

    void open(double duration) {
        Scene scene = test::sample("incline.json");
        scene.stages.back().duration = duration;
        document_.startNew(std::move(scene));
        ASSERT_TRUE(waitFor([&] { return document_.checkIsCurrent(); }));
    }

    QString text(const char* name) const { return panel_->findChild<QLabel*>(name)->text(); }
    QPushButton& button(const char* name) const { return *panel_->findChild<QPushButton*>(name); }
    int listed() const { return panel_->findChild<QTreeWidget*>("stressPushes")->topLevelItemCount(); }

    Document document_;
    StressRuns runs_{document_};
    std::unique_ptr<StressPanel> panel_;
};

TEST_F(StressPanelTest, ListsEveryPushAndSaysWhatToSet) {
    open(0.02);
    button("stress.start").click();
    EXPECT_TRUE(runs_.isBusy());
    EXPECT_TRUE(button("stress.stop").isVisible());
    ASSERT_TRUE(waitFor([&] { return !runs_.isBusy(); }, 15000));
    EXPECT_EQ(static_cast<std::size_t>(listed()), stressPushes(*document_.committed()).size());
    EXPECT_EQ(text("stressAnswer").toStdString() + "\n", stressAnswer(runs_.test()));
    EXPECT_TRUE(text("stressDetail").isEmpty());
    Scene changed = *document_.committed();
    changed.title += "!";
    document_.apply("title", changed);
    Q_EMIT runs_.changed();
    EXPECT_TRUE(text("stressDetail").contains("changed")) << text("stressDetail").toStdString();
}

TEST_F(StressPanelTest, StopKeepsThePushesMadeSoFar) {
    open(1.0);
    button("stress.start").click();
    ASSERT_TRUE(waitFor([&] { return listed() > 0; }, 15000));
    button("stress.stop").click();
    ASSERT_TRUE(waitFor([&] { return !runs_.isBusy(); }, 15000));
    EXPECT_TRUE(runs_.test().interrupted);
    EXPECT_GT(listed(), 0);
    EXPECT_TRUE(text("stressDetail").startsWith("Stopped")) << text("stressDetail").toStdString();
}

TEST_F(StressPanelTest, ASceneThatCannotRunIsAProblem) {
    document_.startNew(Scene{});
    ASSERT_TRUE(waitFor([&] { return document_.checkIsCurrent(); }));
    button("stress.start").click();
    EXPECT_FALSE(runs_.isBusy());
    EXPECT_EQ(text("stressAnswer"), runs_.problem());
    EXPECT_FALSE(runs_.problem().isEmpty());
}

/// In a narrow, low dock the wrapped answer keeps all its lines; the panel scrolls.
TEST_F(StressPanelTest, AnswerIsWholeInANarrowLowDock) {
    open(0.02);
    button("stress.start").click();
    ASSERT_TRUE(waitFor([&] { return !runs_.isBusy(); }, 15000));
    const auto* answer = panel_->findChild<QLabel*>("stressAnswer");
    for (const QSize size : {QSize(220, 120), QSize(420, 100), QSize(1000, 300)}) {
        panel_->resize(size);
        EXPECT_TRUE(waitFor([&] { return answer->height() >= answer->heightForWidth(answer->width()); }, 1000))
            << size.width() << " px: " << answer->height() << " of " << answer->heightForWidth(answer->width());
        EXPECT_GE(panel_->findChild<QTreeWidget*>("stressPushes")->height(), 72);
    }
}

/// In a narrow dock the button is below the text, whole.
TEST_F(StressPanelTest, ButtonIsWholeInANarrowDock) {
    panel_->resize(200, 320);
    waitFor([&] { return button("stress.start").geometry().right() < 200; }, 1000);
    EXPECT_LE(button("stress.start").geometry().right(), panel_->width() - 1);
    EXPECT_GE(button("stress.start").width(), button("stress.start").sizeHint().width());
}

}  // namespace
}  // namespace keyblock
