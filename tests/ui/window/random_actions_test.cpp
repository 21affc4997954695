// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Somebody does at random what there is to do. Nothing may crash or hang, and undo
// must lead back to the first scene to the byte. `KEYBLOCK_ACTIONS=10000` does more
// of it, `KEYBLOCK_SEED` something else, `KEYBLOCK_TELL` says what was done.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"
#include "tests/ui/window/somebody.h"

#include "solver/files/scene_file.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/runs/runs.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace keyblock {
namespace {

constexpr int mostTimes = 10;

int numberFrom(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

/// Copies, since somebody saves; a run of another scene, and drawings, to be dropped.
QStringList filesIn(const std::filesystem::path& folder) {
    const std::string samples = KEYBLOCK_SAMPLES_DIR, data = KEYBLOCK_TEST_DATA_DIR;
    QStringList files;
    for (const std::string& file : {samples + "/rebar-stated.json", samples + "/drift-bolted.json",
                                    data + "/import/feet.dxf", data + "/import/bolts.csv", data + "/import/truncated.dxf",
                                    data + "/broken/missing-comma.json"}) {
        std::filesystem::copy(file, folder);
        files << QString::fromStdString((folder / std::filesystem::path(file).filename()).string());
    }
    test::putContent(folder / "no-run.kbrun", "this is no run");
    return files << QString::fromStdString((folder / "no-run.kbrun").string());
}

void tellCounts(const Somebody& somebody) {
    for (const auto& [what, times] : somebody.counts()) std::cerr << times << "  " << what << "\n";
}

TEST(RandomActions, DoNotCrashOrHangAndUndoRestoresTheScene) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QStringList files = filesIn(scratch.path());
    QDir::setCurrent(QString::fromStdString(scratch.path().string()));
    Themes themes;
    MainWindow window(themes);
    window.show();
    window.openPath(files[1]);
    auto& document = *window.findChild<Document*>();
    ASSERT_FALSE(document.scene()->title.empty());
    std::string before = wholeSceneText(*document.scene());
    // Somebody may open another scene; undo leads back to that one then.
    QObject::connect(&document, &Document::replaced, [&] { before = wholeSceneText(*document.scene()); });
    int runs = 0;
    QObject::connect(window.findChild<Runs*>(), &Runs::sessionChanged,
                     [&] { runs += window.findChild<Runs*>()->isRunning() ? 1 : 0; });
    const int actions = numberFrom("KEYBLOCK_ACTIONS", 500);
    {
        Somebody somebody(window, static_cast<unsigned>(numberFrom("KEYBLOCK_SEED", 1)), files);
        // By chance, and by what fits on the screen, some kinds come late: then there are more actions.
        const auto missing = [&]() -> std::string {
            if (runs == 0) return "run";
            for (const char* what : {"tool ", "dock ", "edit.undo", "drop", "menu action", "dialog ", "draw", "popup"})
                if (somebody.countOf(what) == 0) return what;
            return {};
        };
        const bool reachesAll = actions >= 500;
        for (int i = 0; i < actions || (reachesAll && i < mostTimes * actions && !missing().empty()); ++i) {
            QElapsedTimer timer;
            timer.start();
            somebody.act();
            QApplication::processEvents();
            EXPECT_LT(timer.elapsed(), 60000) << "hung at action " << i << ": " << somebody.last();
            EXPECT_TRUE(window.isVisible()) << "gone at action " << i << ": " << somebody.last();
        }
        if (std::getenv("KEYBLOCK_TELL")) tellCounts(somebody);
        if (reachesAll) {
            EXPECT_EQ(missing(), "");
        }
    }
    document.endPreview();
    document.undo().setIndex(0);
    EXPECT_EQ(wholeSceneText(*document.scene()), before);
    QDir::setCurrent("/");
}

}  // namespace
}  // namespace keyblock
