// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program that edits is killed at random moments; at most the last two seconds of
// work may be lost. KEYBLOCK_KILLS sets the number of kills (3).
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/document/recovery.h"

#include <QProcess>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <random>
#include <sstream>
#include <string>

namespace keyblock {
namespace {

constexpr char sample[] = KEYBLOCK_SAMPLES_DIR "/tower-100.json";

struct Said {
    double last = 0.0;  // [s]
    std::size_t states = 0;
    std::map<std::string, double> stood;  // by hash of the scene: last time it was current [s]
};

/// Output of the editor until it was killed; an incomplete line is ignored.
Said runAndKill(const QString& folder, int seed, int milliseconds) {
    QProcess editor;
    editor.start(KEYBLOCK_EDITOR, {folder, sample, QString::number(seed)});
    EXPECT_TRUE(editor.waitForStarted());
    editor.waitForReadyRead();
    editor.waitForFinished(milliseconds);
    editor.kill();
    editor.waitForFinished();
    Said said;
    std::istringstream lines(editor.readAllStandardOutput().toStdString());
    std::string line;
    while (std::getline(lines, line) && !lines.eof()) {
        said.last = std::stod(line);
        ++said.states;
        said.stood[line.substr(line.find(' ') + 1)] = said.last;
    }
    return said;
}

TEST(JournalKills, NothingOlderThanTwoSecondsIsLost) {
    NEED_SCREEN();
    const char* asked = std::getenv("KEYBLOCK_KILLS");
    const int kills = asked ? std::atoi(asked) : 3;
    const std::string first = sceneHash(*readSceneFile(sample).scene);
    std::mt19937 chance(1);
    double worst = 0.0;
    for (int kill = 0; kill < kills; ++kill) {
        const test::ScratchFolder scratch;
        const QString folder = QString::fromStdString(scratch.path().string());
        const Said said = runAndKill(folder, kill, 50 + static_cast<int>(chance() % 1500));
        const std::vector<Abandoned> found = abandonedJournals(folder);
        if (found.empty()) {
            EXPECT_LE(said.stood.size(), 2u) << "kill " << kill;
            continue;
        }
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].damage, "") << "kill " << kill;
        Document document;
        Journal journal(document, folder);
        EXPECT_EQ(recover(found[0], Recover::Everything, document, journal), "");
        const auto state = said.stood.find(sceneHash(*document.scene()));
        if (state != said.stood.end()) worst = std::max(worst, said.last - state->second);
        else EXPECT_GE(found[0].changes, said.states) << "kill " << kill;  // written, and killed before it was printed
        document.undo().setIndex(0);
        EXPECT_EQ(sceneHash(*document.scene()), first) << "kill " << kill;
    }
    RecordProperty("longest_loss_ms", static_cast<int>(worst * 1e3));
    EXPECT_LT(worst, 2.0);
}

}  // namespace
}  // namespace keyblock
