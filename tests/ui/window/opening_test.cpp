// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An opened file is ready to work with: a run opens with its scene, an imported drawing
// can be run, undone and recovered.
#include "tests/scratch_folder.h"
#include "tests/ui/runs/stored_run.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/document/journal.h"
#include "ui/look/theme.h"
#include "ui/runs/runs.h"
#include "ui/runs/time_cursor.h"
#include "ui/start/import_window.h"
#include "ui/window/main_window.h"

#include <QDockWidget>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <filesystem>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

class Opening : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        themes_ = std::make_unique<Themes>();
        window_ = std::make_unique<MainWindow>(*themes_);
        window_->show();
    }

    Document& document() { return *window_->findChild<Document*>(); }
    void open(const fs::path& path) { window_->openPath(QString::fromStdString(path.string())); }
    bool showsRun() {
        return waitFor([&] { return window_->findChild<TimeCursor*>()->hasMoment(); });
    }

    test::ScratchFolder folder_;
    std::unique_ptr<Themes> themes_;
    std::unique_ptr<MainWindow> window_;
};

TEST_F(Opening, ARunOpensWithTheSceneFromItsStore) {
    const Scene scene = test::sample("incline.json");
    test::slidingRun(folder_.path() / "elsewhere-1.kbrun", 0.05);
    open(folder_.path() / "elsewhere-1.kbrun");
    ASSERT_TRUE(showsRun());
    EXPECT_EQ(document().committed()->blocks.size(), scene.blocks.size());
    EXPECT_EQ(document().committed()->stages.front().duration, 0.05);
    EXPECT_TRUE(document().path().isEmpty());
    EXPECT_FALSE(document().isModified());
    const Runs& runs = *window_->findChild<Runs*>();
    ASSERT_TRUE(waitFor([&] { return !runs.entries().empty(); }));
    EXPECT_EQ(runs.entries().size(), 1u);
    EXPECT_FALSE(runs.entries().front().ofEarlierScene);
}

TEST_F(Opening, ARunOpensWithItsSceneFileWhileThatIsUnchanged) {
    Scene scene = test::sample("incline.json");
    scene.stages.front().duration = 0.05;
    scene.output.every = 0.01;
    writeSceneFile(folder_.path() / "slope.json", scene);
    const SceneReading written = readSceneFile(folder_.path() / "slope.json");
    test::storedRun(*written.scene, folder_.path() / "slope-2.kbrun");
    open(folder_.path() / "slope-2.kbrun");
    ASSERT_TRUE(showsRun());
    EXPECT_TRUE(document().path().endsWith("slope.json"));
}

std::string group(int code, const std::string& value) { return std::to_string(code) + "\n" + value + "\n"; }

std::string lineOn(const std::string& layer, double x0, double y0, double x1, double y1) {
    return group(0, "LINE") + group(8, layer) + group(10, std::to_string(x0)) + group(20, std::to_string(y0)) +
           group(11, std::to_string(x1)) + group(21, std::to_string(y1));
}

std::string drawing() {
    return group(0, "SECTION") + group(2, "HEADER") + group(9, "$INSUNITS") + group(70, "6") + group(0, "ENDSEC") +
           group(0, "SECTION") + group(2, "ENTITIES") + lineOn("boundary", 0, 0, 10, 0) + lineOn("boundary", 10, 0, 10, 8) +
           lineOn("boundary", 10, 8, 0, 8) + lineOn("boundary", 0, 8, 0, 0) + lineOn("joints", -1, 2, 11, 6) +
           group(0, "ENDSEC") + group(0, "EOF");
}

TEST_F(Opening, AnImportedDrawingCanBeRunUndoneAndRecovered) {
    const fs::path file = folder_.path() / "section.dxf";
    test::putContent(file, drawing());
    open(file);
    auto* importing = window_->findChild<ImportWindow*>();
    ASSERT_TRUE(importing);
    auto* import = importing->findChild<QPushButton*>("import.import");
    ASSERT_TRUE(waitFor([&] { return import->isEnabled(); }));
    import->click();
    EXPECT_EQ(document().committed()->supports.size(), 3u);
    EXPECT_EQ(document().committed()->stages.size(), 2u);
    EXPECT_TRUE(document().isModified());
    EXPECT_TRUE(document().undo().canUndo());
    const Runs& runs = *window_->findChild<Runs*>();
    EXPECT_EQ(runs.nothingToRun().toStdString(), "");
    Journal& journal = *window_->findChild<Journal*>();
    EXPECT_TRUE(journal.flush());
    EXPECT_TRUE(fs::exists(journal.path().toStdString()));
    ASSERT_TRUE(waitFor([&] { return document().checkIsCurrent(); }));
    const auto stateOf = [&](const char* tab) { return window_->findChild<QToolButton*>(tab)->accessibleDescription(); };
    EXPECT_EQ(stateOf("workflow.0"), "done");
    EXPECT_EQ(stateOf("workflow.2"), "") << "there are no bolts";
    document().undo().undo();
    EXPECT_FALSE(document().committed()->domain);
    EXPECT_FALSE(document().isModified());
}

TEST_F(Opening, WhatCannotBeOpenedStaysReported) {
    test::putContent(folder_.path() / "empty.kbrun", "");
    test::putContent(folder_.path() / "text.kbrun", "no run at all, but long enough");
    fs::create_directory(folder_.path() / "folder.json");
    auto* dock = window_->findChild<QDockWidget*>("readingDock");
    const auto* problems = window_->findChild<QTreeWidget*>("reading.problems");
    for (const auto& [name, words] : std::vector<std::pair<std::string, QString>>{
             {"empty.kbrun", "it is empty"},
             {"text.kbrun", "it is not a run store"},
             {"missing.kbrun", "there is no such file"},
             {"folder.json", "this is a folder, not a scene file"},
             {"missing.json", "the file cannot be opened: No such file or directory"}}) {
        dock->hide();
        open(folder_.path() / name);
        EXPECT_TRUE(waitFor([&] { return dock->isVisible(); })) << name;
        ASSERT_EQ(problems->topLevelItemCount(), 1) << name;
        EXPECT_EQ(problems->topLevelItem(0)->text(1), words) << name;
        EXPECT_FALSE(problems->topLevelItem(0)->text(2).isEmpty()) << name;
        EXPECT_FALSE(document().isModified()) << name;
    }
}

TEST_F(Opening, AnotherSceneOpensAtTheGeometryStep) {
    test::slidingRun(folder_.path() / "a-1.kbrun", 0.05);
    open(folder_.path() / "a-1.kbrun");
    ASSERT_TRUE(showsRun());
    const auto isChosen = [&](const char* tab) { return window_->findChild<QToolButton*>(tab)->isChecked(); };
    EXPECT_TRUE(isChosen("workflow.5"));
    open(KEYBLOCK_SAMPLES_DIR "/incline.json");
    EXPECT_TRUE(isChosen("workflow.0"));
}

TEST_F(Opening, TheFileMenuListsRecentScenes) {
    const fs::path copy = folder_.path() / "slope.json";
    fs::copy_file(KEYBLOCK_SAMPLES_DIR "/incline.json", copy);
    open(copy);
    auto* recent = window_->findChild<QMenu*>("menu.recent");
    ASSERT_TRUE(recent);
    Q_EMIT recent->aboutToShow();
    ASSERT_FALSE(recent->actions().isEmpty());
    EXPECT_EQ(recent->actions().front()->text(), "slope.json");
    EXPECT_TRUE(recent->actions().front()->isEnabled());
}

}  // namespace
}  // namespace keyblock
