// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program that edits is killed after random edits; at most the last few edits may be
// lost. They are counted, so that a slow machine does not matter: the program makes about
// a hundred edits a second. KEYBLOCK_KILLS sets the number of kills (3).
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

constexpr std::size_t mostLost = 20;  // edits

struct Said {
    std::size_t states = 0;
    std::map<std::string, std::size_t> stood;  // by hash of the scene: number of the last state with it, from 1
};

/// Output of the editor until it was killed after so many states; an incomplete line is ignored.
Said runAndKill(const QString& folder, int seed, int states) {
    QProcess editor;
    editor.start(KEYBLOCK_EDITOR, {folder, sample, QString::number(seed)});
    EXPECT_TRUE(editor.waitForStarted());
    constexpr int limit = 60000;  // [ms], ends a broken test
    QByteArray output;
    while (output.count('\n') < states && editor.waitForReadyRead(limit)) output += editor.readAllStandardOutput();
    EXPECT_GE(output.count('\n'), states);
    editor.kill();
    editor.waitForFinished(limit);
    Said said;
    std::istringstream lines((output + editor.readAllStandardOutput()).toStdString());
    std::string line;
    while (std::getline(lines, line) && !lines.eof()) said.stood[line] = ++said.states;
    return said;
}

TEST(JournalKills, OnlyTheLastEditsAreLost) {
    NEED_SCREEN();
    const char* asked = std::getenv("KEYBLOCK_KILLS");
    const int kills = asked ? std::atoi(asked) : 3;
    const std::string first = sceneHash(*readSceneFile(sample).scene);
    std::mt19937 chance(1);
    std::size_t worst = 0;
    for (int kill = 0; kill < kills; ++kill) {
        const test::ScratchFolder scratch;
        const QString folder = QString::fromStdString(scratch.path().string());
        const Said said = runAndKill(folder, kill, 1 + static_cast<int>(chance() % 100));
        const std::vector<Abandoned> found = abandonedJournals(folder);
        if (found.empty()) {
            EXPECT_LE(said.states, 1 + mostLost) << "kill " << kill;
            continue;
        }
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].damage, "") << "kill " << kill;
        Document document;
        Journal journal(document, folder);
        EXPECT_EQ(recover(found[0], Recover::Everything, document, journal), "");
        const auto state = said.stood.find(sceneHash(*document.scene()));
        if (state != said.stood.end()) worst = std::max(worst, said.states - state->second);
        else EXPECT_GE(found[0].changes, said.states) << "kill " << kill;  // written, and killed before it was printed
        document.undo().setIndex(0);
        EXPECT_EQ(sceneHash(*document.scene()), first) << "kill " << kill;
    }
    RecordProperty("most_lost", static_cast<int>(worst));
    EXPECT_LE(worst, mostLost);
}

}  // namespace
}  // namespace keyblock
