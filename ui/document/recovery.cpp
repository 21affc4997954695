// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recovery.h"

#include "solver/files/scene_rescue.h"
#include "ui/document/document.h"
#include "ui/document/journal_text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>

namespace keyblock {

namespace {

constexpr qint64 secondsToBegin = 10;  // an empty journal younger than this is about to be written

/// A journal that is nobody's, held while it is looked at.
class Held {
public:
    explicit Held(const QString& path) : file_(::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC)) {
        isFree_ = file_ >= 0 && (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK);
    }
    ~Held() {
        if (file_ >= 0) ::close(file_);
    }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;

    bool isFree() const { return isFree_; }

private:
    int file_;
    bool isFree_;
};

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Journalled read(const QString& path, std::optional<std::size_t> mostChanges = {}) {
    const QByteArray content = contentOf(path);
    return readJournal({content.constData(), static_cast<std::size_t>(content.size())}, mostChanges);
}

bool isWorthwhile(const Journalled& journal) {
    const bool isInFile = journal.saved == journal.index &&
                          (journal.path.empty() || QFileInfo::exists(QString::fromStdString(journal.path)));
    return journal.changes > 0 && !isInFile;
}

void putAside(const QString& journal) { QFile::rename(journal, journal + ".damaged"); }

Abandoned abandonedOf(const QFileInfo& file, const Journalled& journal) {
    Abandoned abandoned;
    abandoned.journal = file.filePath();
    abandoned.path = QString::fromStdString(journal.path);
    abandoned.title = abandoned.path.isEmpty() ? QString::fromStdString(journal.name)
                                               : QFileInfo(abandoned.path).fileName();
    abandoned.changes = journal.changes;
    abandoned.lastStep = QString::fromStdString(journal.steps[journal.index].name);
    abandoned.last = file.lastModified();
    abandoned.damage = QString::fromStdString(journal.damage);
    return abandoned;
}

std::vector<RestoredStep> stepsOf(const Journalled& journal) {
    std::vector<RestoredStep> steps;
    const std::filesystem::path folder = std::filesystem::path(journal.path).parent_path();
    for (const JournalStep& step : journal.steps) {
        SceneRescue rescue = rescueSceneText(step.text, journal.path, folder);
        if (!rescue.scene) return {};
        steps.push_back({QString::fromStdString(step.name), std::make_shared<const Scene>(std::move(*rescue.scene))});
    }
    return steps;
}

}  // namespace

std::vector<Abandoned> abandonedJournals(const QString& folder, QStringList* unusable) {
    std::vector<Abandoned> found;
    for (const QFileInfo& file : QDir(folder).entryInfoList({"*.journal"}, QDir::Files, QDir::Time)) {
        const Held held(file.filePath());
        const bool isAboutToBegin =
            file.size() == 0 && file.lastModified().secsTo(QDateTime::currentDateTime()) < secondsToBegin;
        if (!held.isFree() || isAboutToBegin) continue;
        const Journalled journal = read(file.filePath());
        if (journal.steps.empty() && !journal.damage.empty()) {
            putAside(file.filePath());
            if (unusable) *unusable << file.filePath() + ".damaged";
        } else if (!isWorthwhile(journal) && journal.damage.empty()) {
            QFile::remove(file.filePath());
        } else {
            found.push_back(abandonedOf(file, journal));
        }
    }
    return found;
}

QString recover(const Abandoned& abandoned, Recover what, Document& document, Journal& journal) {
    const Held held(abandoned.journal);
    if (!held.isFree()) return Document::tr("Another window recovers %1, or its journal is gone.").arg(abandoned.title);
    const bool withoutLast = what == Recover::WithoutLastCommand && abandoned.changes > 0;
    const Journalled told = read(abandoned.journal, withoutLast ? std::optional(abandoned.changes - 1) : std::nullopt);
    std::vector<RestoredStep> steps = stepsOf(told);
    if (steps.empty()) return Document::tr("The journal of %1 cannot be read.").arg(abandoned.title);
    document.restore(std::move(steps), told.index, told.saved, QString::fromStdString(told.path),
                     QString::fromStdString(told.name));
    journal.flush();
    if (told.damage.empty()) QFile::remove(abandoned.journal);
    else putAside(abandoned.journal);
    return {};
}

void giveUp(const Abandoned& abandoned) {
    const Held held(abandoned.journal);
    if (held.isFree()) QFile::remove(abandoned.journal);
}

}  // namespace keyblock
