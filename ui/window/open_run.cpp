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

/// \param why set to the reason if the run cannot be read
std::optional<SceneOfRun> sceneOfRun(const QString& store, std::string& why) {
    try {
        const std::string path = store.toStdString();
        SceneOfRun found{runSummary(path).sceneHash, storedScene(path), {}};
        found.file = sceneFileOf(QFileInfo(store), found.hash);
        return found;
    } catch (const std::exception& error) {
        why = error.what();
        return std::nullopt;
    }
}

/// A run that cannot be read is reported as a scene is: until another document is opened. The message is that of the
/// command line, "cannot read PATH: reason; remedy".
void reportUnreadable(Document& document, const QString& path, std::string why) {
    const std::string start = "cannot read " + path.toStdString() + ": ";
    if (why.starts_with(start)) why.erase(0, start.size());
    const std::size_t parting = why.rfind("; ");
    Problem problem;
    problem.file = path.toStdString();
    problem.message = why.substr(0, parting);
    if (parting != std::string::npos) problem.remedy = why.substr(parting + 2);
    Q_EMIT document.readInPart({path, {}, {problem}, 0, false});
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
    std::string why;
    std::optional<SceneOfRun> found = sceneOfRun(path, why);
    if (!found) reportUnreadable(document, path, why);
    if (found && !takeScene(document, std::move(*found), QFileInfo(path).completeBaseName(), window, edits)) return;
    runs.open(path);
}

}  // namespace keyblock
