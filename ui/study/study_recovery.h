// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps a study with unsaved edits in a file of the user's data folder, so that a crash
// loses at most the last two seconds.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include <optional>
#include <string>

namespace keyblock {

class StudyDraft;

/// The folder of these files, within the folder for the program's user data.
QString studyRecoveryFolder();

/// A study that another program did not save before it ended.
struct LostStudy {
    QString file;  // in which it is kept
    QString path;  // of the study; empty: never saved
    QString scene;  // path of its scene
    std::string text;

    QString title() const;
};

class StudyRecovery : public QObject {
    Q_OBJECT

public:
    explicit StudyRecovery(StudyDraft& draft, const QString& folder = studyRecoveryFolder(), QObject* parent = nullptr);
    /// Writes pending edits. The file stays unless the study was saved or `discard` has been called.
    ~StudyRecovery() override;

    /// The study of a program that has ended, if there is one.
    std::optional<LostStudy> lost() const;
    /// Makes it the one that is edited.
    void recover(const LostStudy& lost);
    void remove(const LostStudy& lost);
    /// Removes the file of this study, because its edits are discarded.
    void discard();
    /// Writes pending edits now.
    void flush();

private:
    void follow();

    StudyDraft& draft_;
    QString folder_, file_;
    QTimer later_;
};

}  // namespace keyblock
