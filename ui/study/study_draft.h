// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The study that is being edited: a plain value with its file and the results of its
// check, which runs in the background.
#pragma once

#include "solver/study/study_file.h"
#include "ui/document/background.h"

#include <QObject>
#include <QString>

#include <memory>

namespace keyblock {

class Document;

class StudyDraft : public QObject {
    Q_OBJECT

public:
    explicit StudyDraft(const Document& document, QObject* parent = nullptr);

    bool isOpen() const { return isOpen_; }
    const Study& study() const { return study_; }
    const QString& path() const { return path_; }  // empty: never saved
    QString title() const;  // file name, or "untitled study"
    bool isModified() const { return isOpen_ && study_ != saved_; }

    /// Absolute path of the scene; empty if the study names none.
    QString scenePath() const;
    /// Whether the document is the scene of the study.
    bool isOfDocument() const;
    /// Whether the document is the scene of the study and has edits that are not in its file.
    bool sceneIsUnsaved() const;

    /// Says that the document shows the scene of a case: what differs from its file is not meant for the study.
    void showsCase(std::shared_ptr<const Scene> scene);

    /// Starts a study of a scene file. It counts as modified once it has a parameter.
    void startNew(const QString& scenePath);

    /// Opens a file. A study with errors is opened too; a file of which some values cannot be read becomes a study
    /// without a file, so that saving does not lose them. \return why nothing can be opened; empty if it is open
    QString open(const QString& path);

    /// Opens a study from its text, as after a crash. \param path its file; empty: none
    void restore(const std::string& text, const QString& path, const QString& scenePath);

    /// Writes the file. \throws CannotWrite
    void save(const QString& path);

    void close();

    /// Makes `study` the one that is edited, and checks it.
    void change(Study study);

    /// The latest finished check; null before the first.
    const std::shared_ptr<const StudyReading>& checked() const { return checked_; }
    bool checkIsCurrent() const { return checks_ == checkedCount_; }

    /// The text of the study with an absolute path of its scene, which can be restored anywhere.
    std::string portableText() const;

Q_SIGNALS:
    void changed();  // the study, its file, or whether it is modified
    void checkedChanged();
    void replaced();  // another study is open, or none

private:
    void check();
    void begin(Study study, const QString& path, const QString& folder);
    QString assumedPath() const;

    const Document& document_;
    bool isOpen_ = false;
    Study study_, saved_;
    QString path_, folder_;  // folder: to which the path of the scene is relative
    std::shared_ptr<const Scene> case_;
    std::shared_ptr<const StudyReading> checked_;
    long checks_ = 0, checkedCount_ = 0;
    Background checking_;  // last member: its destructor waits for the thread
};

}  // namespace keyblock
