// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_draft.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"

#include <QDir>
#include <QFileInfo>

#include <filesystem>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

/// Path of a file seen from a folder; the path itself if that is not possible.
std::string relativeTo(const QString& folder, const QString& file) {
    return QDir(folder).relativeFilePath(file).toStdString();
}

Study emptyStudy() {
    Study study;
    study.plan.cases = 100;
    return study;
}

}  // namespace

StudyDraft::StudyDraft(const Document& document, QObject* parent) : QObject(parent), document_(document) {
    const auto recheck = [this] {
        if (isOpen_ && isOfDocument()) check();
    };
    connect(&document, &Document::checkedChanged, this, recheck);
    connect(&document, &Document::fileChanged, this, recheck);
}

QString StudyDraft::title() const { return path_.isEmpty() ? tr("untitled study") : QFileInfo(path_).fileName(); }

QString StudyDraft::scenePath() const {
    return study_.scene.empty() ? QString()
                                : QDir::cleanPath(QDir(folder_).filePath(QString::fromStdString(study_.scene)));
}

bool StudyDraft::isOfDocument() const {
    return !document_.path().isEmpty() && QFileInfo(document_.path()) == QFileInfo(scenePath());
}

bool StudyDraft::sceneIsUnsaved() const {
    const bool isCase = case_ && (case_ == document_.committed() || *case_ == *document_.committed());
    return isOfDocument() && document_.isModified() && !isCase;
}

void StudyDraft::showsCase(std::shared_ptr<const Scene> scene) {
    case_ = std::move(scene);
    if (isOpen_) check();
}

QString StudyDraft::assumedPath() const { return path_.isEmpty() ? folder_ + "/untitled.json" : path_; }

void StudyDraft::begin(Study study, const QString& path, const QString& folder) {
    study_ = std::move(study);
    saved_ = study_;
    path_ = path;
    folder_ = folder;
    isOpen_ = true;
    checked_.reset();
    Q_EMIT replaced();
    Q_EMIT changed();
    check();
}

void StudyDraft::startNew(const QString& scenePath) {
    Study study = emptyStudy();
    const QFileInfo scene(scenePath);
    study.scene = scene.fileName().toStdString();
    begin(std::move(study), {}, scene.absolutePath());
}

QString StudyDraft::open(const QString& path) {
    const QFileInfo file(path);
    const StudyReading reading = readStudyFile(path.toStdString());
    if (!reading.partly)
        return reading.problems.empty() ? tr("The file is not a study.")
                                        : QString::fromStdString(oneLine(reading.problems.front()));
    begin(*reading.partly, reading.isWhole ? file.absoluteFilePath() : QString(), file.absolutePath());
    return {};
}

void StudyDraft::restore(const std::string& text, const QString& path, const QString& scenePath) {
    const StudyReading reading = readStudyText(text, scenePath.toStdString());
    if (!reading.partly) return;
    Study study = *reading.partly;
    const QString folder = path.isEmpty() ? QFileInfo(scenePath).absolutePath() : QFileInfo(path).absolutePath();
    study.scene = relativeTo(folder, scenePath);
    begin(std::move(study), path, folder);
    saved_ = {};  // it is not in its file
    Q_EMIT changed();
}

void StudyDraft::save(const QString& path) {
    const QFileInfo file(path);
    Study written = study_;
    if (!written.scene.empty() && file.absolutePath() != folder_)
        written.scene = relativeTo(file.absolutePath(), scenePath());
    writeStudyFile(path.toStdString(), written);
    study_ = saved_ = written;
    path_ = file.absoluteFilePath();
    folder_ = file.absolutePath();
    Q_EMIT changed();
    check();
}

void StudyDraft::close() {
    isOpen_ = false;
    study_ = saved_ = {};
    path_.clear();
    checked_.reset();
    Q_EMIT replaced();
    Q_EMIT changed();
}

void StudyDraft::change(Study study) {
    if (study == study_) return;
    study_ = std::move(study);
    Q_EMIT changed();
    check();
}

std::string StudyDraft::portableText() const {
    Study whole = study_;
    if (!whole.scene.empty()) whole.scene = scenePath().toStdString();
    return studyText(whole);
}

/// Checks the study with the scene as it is in the window, which may differ from its file.
void StudyDraft::check() {
    const long number = ++checks_;
    const auto scene = sceneIsUnsaved() ? document_.committed() : nullptr;
    checking_.ask([this, number, scene, text = studyText(study_), path = assumedPath().toStdString()] {
        const std::string sceneNow = scene ? wholeSceneText(*scene) : std::string();
        auto reading = std::make_shared<const StudyReading>(readStudyText(text, path, scene ? &sceneNow : nullptr));
        return Background::Result([this, number, reading] {
            checked_ = reading;
            checkedCount_ = number;
            Q_EMIT checkedChanged();
        });
    });
}

}  // namespace keyblock
