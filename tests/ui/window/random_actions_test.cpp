// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random-input ("monkey") test of the whole window. Nothing may crash or hang, and undo
// must restore the first scene byte by byte. `KEYBLOCK_ACTIONS=10000` does more
// actions, `KEYBLOCK_SEED` other ones, `KEYBLOCK_TELL` prints them.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"
#include "tests/ui/window/random_user.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/runs/runs.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDir>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <signal.h>
#include <unistd.h>

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

/// Copies, since the random user saves; a run of another scene, and drawings, to be dropped.
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

void tellCounts(const RandomUser& user) {
    for (const auto& [what, times] : user.counts()) std::cerr << times << "  " << what << "\n";
}

/// Ends the program if an action does not end, and names the action.
class EndOfHang {
public:
    explicit EndOfHang(const RandomUser& user) {
        constexpr unsigned longest = 300;  // [s]
        user_ = &user;
        ::signal(SIGALRM, [](int) {
            std::cerr << "hung at: " << user_->last() << std::endl;
            ::_exit(1);
        });
        ::alarm(longest);
    }
    ~EndOfHang() { ::alarm(0); }
    EndOfHang(const EndOfHang&) = delete;
    EndOfHang& operator=(const EndOfHang&) = delete;

private:
    static inline const RandomUser* user_ = nullptr;
};

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
    // The random user may open another scene; undo then leads back to that one.
    QObject::connect(&document, &Document::replaced, [&] { before = wholeSceneText(*document.scene()); });
    int runs = 0;
    QObject::connect(window.findChild<Runs*>(), &Runs::sessionChanged,
                     [&] { runs += window.findChild<Runs*>()->isRunning() ? 1 : 0; });
    const int actions = numberFrom("KEYBLOCK_ACTIONS", 500);
    {
        RandomUser user(window, static_cast<unsigned>(numberFrom("KEYBLOCK_SEED", 1)), files);
        // Depending on chance and on the screen, some kinds of actions come late: then more actions are done.
        const auto missing = [&]() -> std::string {
            if (runs == 0) return "run";
            for (const char* what : {"tool ", "dock ", "edit.undo", "drop", "menu action", "dialog ", "draw", "popup"})
                if (user.countOf(what) == 0) return what;
            return {};
        };
        const bool reachesAll = actions >= 500;
        for (int i = 0; i < actions || (reachesAll && i < mostTimes * actions && !missing().empty()); ++i) {
            const EndOfHang end(user);
            user.act();
            QApplication::processEvents();
            EXPECT_TRUE(window.isVisible()) << "gone at action " << i << ": " << user.last();
        }
        if (std::getenv("KEYBLOCK_TELL")) tellCounts(user);
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
