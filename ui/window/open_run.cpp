// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/open_run.h"

#include "solver/files/run_store/run_summary.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/run_store/stored_scene.h"
#include "ui/document/document.h"
#include "ui/runs/runs.h"
#include "ui/window/file_commands.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>

#include <exception>
#include <optional>

namespace keyblock {

namespace {

struct SceneOfRun {
    std::string hash;
    Scene scene;
    QString file;  // file that contains the same scene; empty: none
};

/// Finds the scene file of a run: for `drift-3.kbrun`, `drift-3.json` or `drift.json` if it contains the same scene.
QString sceneFileOf(const QFileInfo& store, const std::string& hash) {
    const QString stem = store.completeBaseName();
    QString withoutNumber = stem;
    withoutNumber.remove(QRegularExpression("-\\d+$"));
    for (const QString& name : {stem, withoutNumber}) {
        const QString path = store.absolutePath() + '/' + name + ".json";
        if (!QFileInfo::exists(path)) continue;
        const SceneReading reading = readSceneFile(path.toStdString());
        if (reading.scene && sceneHash(*reading.scene) == hash) return path;
    }
    return {};
}

std::optional<SceneOfRun> sceneOfRun(const QString& store) {
    try {
        const std::string path = store.toStdString();
        SceneOfRun found{runSummary(path).sceneHash, storedScene(path), {}};
        found.file = sceneFileOf(QFileInfo(store), found.hash);
        return found;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

/// Opens the scene of a run. False if the user keeps the current document.
bool takeScene(Document& document, SceneOfRun found, const QString& name, QWidget& window, UnsavedEdits edits) {
    if (sceneHash(*document.committed()) == found.hash) return true;
    if (edits == UnsavedEdits::Ask && !mayDiscard(document, window)) return false;
    if (found.file.isEmpty() || !document.open(found.file).empty()) document.startNew(std::move(found.scene), name);
    return true;
}

}  // namespace

void openRun(Document& document, Runs& runs, const QString& store, QWidget& window, UnsavedEdits edits) {
    const QString path = QFileInfo(store).absoluteFilePath();
    std::optional<SceneOfRun> found = sceneOfRun(path);
    if (found && !takeScene(document, std::move(*found), QFileInfo(path).completeBaseName(), window, edits)) return;
    runs.open(path);
}

}  // namespace keyblock
