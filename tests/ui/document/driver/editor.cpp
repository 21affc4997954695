// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edits a scene in an endless loop, with undo and redo in between, keeps a journal
// in the given folder, and prints the hash of each state: for tests that kill it.
// `editor FOLDER SCENE SEED`
#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/document/journal.h"

#include <QCoreApplication>
#include <QTimer>
#include <QUndoStack>

#include <cstdio>
#include <cstdlib>
#include <random>

namespace {

using namespace keyblock;

void tell(const Document& document) {
    std::printf("%s\n", sceneHash(*document.scene()).c_str());
    std::fflush(stdout);
}

void editOnce(Document& document, std::mt19937& chance) {
    const auto what = chance() % 10;
    if (what == 0 && document.undo().canUndo()) return document.undo().undo();
    if (what == 1 && document.undo().canRedo()) return document.undo().redo();
    Scene scene = *document.scene();
    if (what < 5) scene.title = "Stütze №" + std::to_string(chance());
    else if (!scene.blocks.empty() && what < 8) scene.blocks.pop_back();
    else scene.joints.push_back({"J" + std::to_string(chance()), {Point(0.0, 1.0 / double(chance() + 1u)), Point(1, 1)}, {}});
    document.apply("Edit " + QString::number(chance() % 1000), std::move(scene));
}

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc != 4) return 2;
    Document document;
    Journal journal(document, argv[1]);
    if (!document.open(argv[2]).empty()) return 1;
    std::mt19937 chance(static_cast<unsigned>(std::atoi(argv[3])));
    tell(document);
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, &application, [&] {
        editOnce(document, chance);
        tell(document);
        timer.setInterval(static_cast<int>(chance() % 20));
    });
    timer.start(0);
    return QCoreApplication::exec();
}
