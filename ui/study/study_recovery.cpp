// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_recovery.h"

#include "ui/study/study_draft.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>

#include <csignal>

namespace keyblock {

namespace {

constexpr int keepTime = 2000;  // [ms]

/// The number of the process in the name of a file, `4711.json`.
pid_t processOf(const QFileInfo& file) { return static_cast<pid_t>(file.completeBaseName().toInt()); }

bool isAlive(pid_t process) { return process > 0 && ::kill(process, 0) == 0; }

std::optional<LostStudy> readLost(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return std::nullopt;
    const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
    if (!json.contains("study")) return std::nullopt;
    return LostStudy{path, json["path"].toString(), json["scene"].toString(), json["study"].toString().toStdString()};
}

}  // namespace

QString studyRecoveryFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/studies/unsaved";
}

QString LostStudy::title() const {
    return path.isEmpty() ? StudyRecovery::tr("An untitled study of %1").arg(QFileInfo(scene).fileName())
                          : StudyRecovery::tr("The study %1").arg(QFileInfo(path).fileName());
}

StudyRecovery::StudyRecovery(StudyDraft& draft, const QString& folder, QObject* parent)
    : QObject(parent), draft_(draft), folder_(folder),
      file_(QStringLiteral("%1/%2.json").arg(folder).arg(QCoreApplication::applicationPid())) {
    later_.setSingleShot(true);
    connect(&later_, &QTimer::timeout, this, &StudyRecovery::flush);
    connect(&draft, &StudyDraft::changed, this, &StudyRecovery::follow);
}

StudyRecovery::~StudyRecovery() {
    if (later_.isActive()) flush();
}

void StudyRecovery::follow() {
    if (!draft_.isModified()) return discard();
    if (!later_.isActive()) later_.start(keepTime);
}

void StudyRecovery::flush() {
    later_.stop();
    if (!draft_.isModified()) return;
    QDir().mkpath(folder_);
    QSaveFile file(file_);
    const QJsonObject json{{"path", draft_.path()},
                           {"scene", draft_.scenePath()},
                           {"study", QString::fromStdString(draft_.portableText())}};
    if (!file.open(QIODevice::WriteOnly)) return;
    file.write(QJsonDocument(json).toJson());
    file.commit();
}

void StudyRecovery::discard() {
    later_.stop();
    QFile::remove(file_);
}

std::optional<LostStudy> StudyRecovery::lost() const {
    for (const QFileInfo& file : QDir(folder_).entryInfoList({"*.json"}, QDir::Files, QDir::Time)) {
        if (file.absoluteFilePath() == QFileInfo(file_).absoluteFilePath() || isAlive(processOf(file))) continue;
        if (auto found = readLost(file.absoluteFilePath())) return found;
    }
    return std::nullopt;
}

void StudyRecovery::recover(const LostStudy& lost) {
    draft_.restore(lost.text, lost.path, lost.scene);
    flush();
    remove(lost);
}

void StudyRecovery::remove(const LostStudy& lost) { QFile::remove(lost.file); }

}  // namespace keyblock
