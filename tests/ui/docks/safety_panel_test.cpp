// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for the factor of safety in the window: its answer, its runs, Stop.
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"
#include "ui/docks/safety_panel.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/runs/safety_search.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTreeWidget>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

class SafetyPanelTest : public ::testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }

    void open(Scene scene) {
        document_.startNew(std::move(scene));
        ASSERT_TRUE(waitFor([&] { return document_.checkIsCurrent(); }));
    }

    Themes themes_;
    Document document_;
    SafetySearch search_{document_};
};

TEST_F(SafetyPanelTest, SearchOnASlopeFindsTheBracket) {
    SafetyPanel panel(search_);
    panel.show();
    Scene scene = test::sample("slope-safety.json");
    scene.safety.tolerance = 0.2;
    open(scene);
    panel.findChild<QPushButton*>("safety.start")->click();
    EXPECT_TRUE(search_.isBusy());
    ASSERT_TRUE(waitFor([&] { return !search_.isBusy(); }, 60000));
    ASSERT_TRUE(search_.found());
    EXPECT_TRUE(search_.found()->lower && search_.found()->upper);
    EXPECT_TRUE(panel.findChild<QLabel*>("safetyAnswer")->text().startsWith("Factor of safety between"));
    EXPECT_EQ(panel.findChild<QTreeWidget*>("safetyRuns")->topLevelItemCount(), int(search_.runs().size()));
}

/// Before any run the panel says what it does; a scene without equilibrium is refused in a sentence.
TEST_F(SafetyPanelTest, SaysWhatItDoesAndWhyItDoesNot) {
    SafetyPanel panel(search_);
    panel.resize(240, 120);
    panel.show();
    const auto* answer = panel.findChild<QLabel*>("safetyAnswer");
    EXPECT_TRUE(answer->text().contains("until it fails")) << answer->text().toStdString();
    panel.resize(600, 160);
    EXPECT_TRUE(waitFor([&] { return !panel.verticalScrollBar()->isVisible(); }, 1000)) << "there is room for all";
    panel.resize(240, 120);
    open(test::sample("burst-rebar.json"));
    panel.findChild<QPushButton*>("safety.start")->click();
    EXPECT_FALSE(search_.isBusy());
    EXPECT_TRUE(answer->text().startsWith("A dynamic stage")) << answer->text().toStdString();
    EXPECT_TRUE(waitFor([&] { return answer->height() >= answer->heightForWidth(answer->width()); }, 1000));
}

TEST_F(SafetyPanelTest, StopEndsTheSearchAndAnEmptySceneIsRefused) {
    search_.start();
    EXPECT_FALSE(search_.isBusy()) << "an empty scene has nothing to run";
    EXPECT_FALSE(search_.problem().isEmpty());
    open(test::sample("slope-safety.json"));
    search_.start();
    EXPECT_TRUE(search_.isBusy());
    search_.stop();
    ASSERT_TRUE(waitFor([&] { return !search_.isBusy(); }, 20000));
}

}  // namespace
}  // namespace keyblock
